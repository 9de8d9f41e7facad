#include "measure/direction_patches.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

constexpr std::size_t kBands = 16;
constexpr std::size_t kSectors = 32;

} // namespace

DirectionPatches::DirectionPatches()
{
  constexpr int kProbes = 8;
  for (std::size_t patch = 0; patch < kBands * kSectors; ++patch)
  {
    centres_.push_back(this->direction(patch, 0.5, 0.5));
    for (int probe = 0; probe < 4 * kProbes; ++probe)
    {
      // The distance is largest along the border of the patch.
      const double t = static_cast<double>(probe % kProbes) / kProbes;
      const int edge = probe / kProbes;
      const double u = edge == 0 ? 0.0 : (edge == 1 ? 1.0 : t);
      const double v = edge == 2 ? 0.0 : (edge == 3 ? 1.0 : t);
      const double cosine = glm::dot(centres_.back(), this->direction(patch, u, v));
      radius_ = std::max(radius_, std::acos(std::min(1.0, cosine)));
    }
  }
  constexpr double kBetweenProbes = 1.05;
  radius_ *= kBetweenProbes;
}

const DirectionPatches& DirectionPatches::instance()
{
  static const DirectionPatches kPatches;
  return kPatches;
}

glm::dvec3 DirectionPatches::direction(std::size_t patch, double u, double v) const
{
  static const double kPi = std::acos(-1.0);
  const std::size_t band = patch / kSectors;
  const double z = 1.0 - 2.0 * (static_cast<double>(band) + u) / static_cast<double>(kBands);
  const double angle =
    2.0 * kPi * (static_cast<double>(patch % kSectors) + v) / static_cast<double>(kSectors);
  const double rho = std::sqrt(std::max(0.0, 1.0 - z * z));
  return { rho * std::cos(angle), rho * std::sin(angle), z };
}

} // namespace medial

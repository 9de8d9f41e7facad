#include "sign/rim_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace medial
{
namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kGroup = 16;
/// Groups are taken as a whole from this many radii on.
constexpr double kFar = 2.0;

} // namespace

double RimBound::Piece::distance(const glm::dvec3& point) const
{
  const glm::dvec3 along = to - from;
  const double square = glm::dot(along, along);
  const double t =
    square > 0.0 ? glm::clamp(glm::dot(point - from, along) / square, 0.0, 1.0) : 0.0;
  return glm::distance(point, from + t * along);
}

RimBound::RimBound(const TriangleChain& lid)
{
  for (const WeightedTriangle& triangle : lid.triangles)
  {
    const glm::dvec3& from = lid.points[triangle.corners[0]];
    const glm::dvec3& to = lid.points[triangle.corners[1]];
    pieces_.push_back({ from, to, glm::distance(from, to), std::abs(triangle.weight) });
  }
  for (std::size_t begin = 0; begin < pieces_.size(); begin += kGroup)
  {
    Group group{ begin, std::min(begin + kGroup, pieces_.size()) };
    for (std::size_t i = group.begin; i < group.end; ++i)
    {
      group.middle += pieces_[i].from / static_cast<double>(group.end - group.begin);
      group.weight += pieces_[i].weight * pieces_[i].length;
    }
    for (std::size_t i = group.begin; i < group.end; ++i)
    {
      group.radius = std::max({ group.radius, glm::distance(group.middle, pieces_[i].from),
        glm::distance(group.middle, pieces_[i].to) });
    }
    groups_.push_back(group);
  }
}

double RimBound::maxGradient(const glm::dvec3& centre, double radius) const
{
  double sum = 0.0;
  for (const Group& group : groups_)
  {
    const double gap = glm::distance(group.middle, centre) - radius - group.radius;
    if (gap > kFar * group.radius)
    {
      sum += group.weight / (4.0 * kPi * gap * gap);
      continue;
    }
    for (std::size_t i = group.begin; i < group.end; ++i)
    {
      const Piece& piece = pieces_[i];
      const double distance = piece.distance(centre) - radius;
      sum += distance > 0.0
        ? piece.weight * std::min(piece.length / distance, kPi) / (4.0 * kPi * distance)
        : HUGE_VAL;
    }
  }
  return sum;
}

} // namespace medial

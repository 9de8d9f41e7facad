#include "sign/continuation.h"

#include "base/simd.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Rounding of a product of lengths, and of a length in grid steps, with a wide margin.
constexpr double kRelativeRounding = 1e-12;
constexpr double kRounding = 1e-9;

/// Adds the change at one triangle to the values that are behind it.
MEDIAL_VECTORISED void addChange(const Continuation::Step& step, const glm::dvec3& centre,
  const Continuation::Points& points, Continuation::Integers& result)
{
  for (int i = 0; i < Continuation::kPoints; ++i)
  {
    const double x = points.x[i] - centre.x;
    const double y = points.y[i] - centre.y;
    const double z = points.z[i] - centre.z;
    double behind =
      step.normals[3].x * x + step.normals[3].y * y + step.normals[3].z * z - step.start;
    for (int side = 0; side < 3; ++side)
    {
      const glm::dvec3& normal = step.normals[side];
      const double inside = normal.x * x + normal.y * y + normal.z * z;
      behind = inside < behind ? inside : behind;
    }
    result.values[i] += behind > 1.0 ? step.change : 0.0;
    result.certain[i] = std::abs(behind) > 1.0 ? result.certain[i] : 0.0;
  }
}

/// Rounds a quadratic function.
MEDIAL_VECTORISED void roundSmooth(const LocalExpansion& smooth, double error,
  const Continuation::Points& points, Continuation::Integers& result)
{
  const glm::dvec3& g = smooth.gradient;
  const glm::dmat3& h = smooth.hessian;
  for (int i = 0; i < Continuation::kPoints; ++i)
  {
    const double x = points.x[i] - smooth.centre.x;
    const double y = points.y[i] - smooth.centre.y;
    const double z = points.z[i] - smooth.centre.z;
    const double value = smooth.value + 0.5 + x * (g.x + 0.5 * h[0][0] * x + h[1][0] * y) +
      y * (g.y + 0.5 * h[1][1] * y + h[2][1] * z) + z * (g.z + 0.5 * h[2][2] * z + h[2][0] * x);
    const double low = std::floor(value - error);
    result.values[i] = low;
    result.certain[i] = low == std::floor(value + error) ? 1.0 : 0.0;
  }
}

} // namespace

Continuation::Continuation(const LocalExpansion& smooth)
  : smooth_(smooth)
{
}

bool Continuation::addStep(const std::array<glm::dvec3, 3>& corners, int weight)
{
  const std::array<glm::dvec3, 3> seen{ corners[0] - smooth_.centre, corners[1] - smooth_.centre,
    corners[2] - smooth_.centre };
  const std::array<double, 3> lengths{ glm::length(seen[0]), glm::length(seen[1]),
    glm::length(seen[2]) };
  const glm::dvec3 normal = glm::cross(seen[1] - seen[0], seen[2] - seen[0]);
  const double volume = glm::dot(seen[0], glm::cross(seen[1], seen[2]));
  const double rounding =
    kRelativeRounding * lengths[0] * lengths[1] * lengths[2] + kRounding * glm::length(normal);
  if (std::abs(volume) <= rounding)
  {
    return false;
  }
  const double sense = volume > 0.0 ? 1.0 : -1.0;
  Step step;
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    const double sideRounding =
      kRelativeRounding * lengths[i] * lengths[next] * std::max(1.0, smooth_.radius);
    step.normals[i] = glm::cross(seen[i], seen[next]) * (sense / sideRounding);
  }
  step.normals[3] = normal * (sense / rounding);
  step.start = std::abs(volume) / rounding;
  step.change = -sense * weight;
  steps_.push_back(step);
  return true;
}

void Continuation::round(const Points& points, double rounding, Integers& result) const
{
  roundSmooth(smooth_, smooth_.error + rounding, points, result);
  for (const Step& step : steps_)
  {
    addChange(step, smooth_.centre, points, result);
  }
}

} // namespace medial

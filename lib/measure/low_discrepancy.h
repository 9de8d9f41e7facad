#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>

namespace medial
{

/// Coordinates in the unit square.
struct SquarePoint
{
  double u;
  double v;
};

/// Point k of the additive sequence of the plastic number (Roberts 2018): every stretch of it
/// covers the unit square evenly.
inline SquarePoint spreadPoint(std::int64_t k)
{
  constexpr double kStepU = 0.7548776662466927600;
  constexpr double kStepV = 0.5698402909980532659;
  const double u = 0.5 + kStepU * static_cast<double>(k);
  const double v = 0.5 + kStepV * static_cast<double>(k);
  return { u - std::floor(u), v - std::floor(v) };
}

/// Maps the unit square to a triangle, and equal areas to equal areas.
inline glm::dvec3 pointInTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
  const SquarePoint& at)
{
  const double root = std::sqrt(at.u);
  return (1.0 - root) * a + root * (1.0 - at.v) * b + root * at.v * c;
}

/// Places samples at k + 1/2, for whole k, along a line of pieces one after the other, so that
/// every piece gets as many as its length, give or take one. Calls `visit(SquarePoint)` for those
/// of one piece.
template <typename Visit>
void forEachSample(double start, double length, const Visit& visit)
{
  const auto first = static_cast<std::int64_t>(std::ceil(start - 0.5));
  const auto end = static_cast<std::int64_t>(std::ceil(start + length - 0.5));
  for (std::int64_t k = first; k < end; ++k)
  {
    visit(spreadPoint(k));
  }
}

} // namespace medial

#pragma once

#include "base/range_check.h"
#include "medial/grid.h"

#include <cmath>
#include <cstddef>
#include <string>

namespace medial
{

/// Largest magnitude of a coordinate and of a radius that can be squared without overflow.
constexpr double kMaxBallValue = 1e100;

/// Checks a ball of a medial axis or model.
/// @param point its number, for the message.
/// @param radius as a float or a double; the message has the digits of its type.
/// @throws Error InvalidInput for a coordinate outside [-kMaxBallValue, kMaxBallValue] or a radius
///   outside [0, kMaxBallValue].
template <typename Real>
void checkBall(std::size_t point, const Point3& centre, Real radius)
{
  const auto name = [point](const char* what)
  { return "point " + std::to_string(point) + ": " + what; };
  for (const double coordinate : centre)
  {
    if (!(std::abs(coordinate) <= kMaxBallValue))
    {
      throwOutside(name("coordinate"), coordinate, closedRange(-kMaxBallValue, kMaxBallValue));
    }
  }
  const auto value = static_cast<double>(radius);
  if (!(value >= 0.0 && value <= kMaxBallValue))
  {
    throwOutside(name("radius"), radius, closedRange(0.0, kMaxBallValue));
  }
}

} // namespace medial

#pragma once

#include "support/point_math.h"

#include <algorithm>
#include <cmath>

// What the files of analytic axes share.
namespace medial::test
{

/// Facets of a round shape of radius 1 per spacing: the sag is some hundredths of it.
inline int segments(double spacing)
{
  return 4 * static_cast<int>(std::ceil(4.0 / std::sqrt(spacing)));
}

inline int subdivisions(double spacing)
{
  return spacing > 0.06 ? 4 : 5;
}

inline Bounds around(const Point3& half)
{
  Bounds bounds;
  bounds.min = { -half[0], -half[1], -half[2] };
  bounds.max = half;
  return bounds;
}

} // namespace medial::test

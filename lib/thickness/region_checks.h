#pragma once

#include "medial/grid.h"
#include "medial/sign_method.h"
#include "medial/thickness_regions.h"

namespace medial
{

/// Which limit a place is beyond.
enum class Beyond : char
{
  Nothing,
  Min,
  Max
};

/// @param value NaN is beyond none.
/// @param atEdge whether the value is that of a convex edge or tip, which does not count as thin.
Beyond beyondOf(float value, bool atEdge, const ThicknessLimits& limits);

/// Returns the grid on which requireInside() decides.
Grid gridForInside(const Bounds& bounds);

/// @param sign what SignMethod::Auto has chosen there.
/// @throws Error as requireInside().
void requireSign(const SignReport& sign);

/// @throws Error InvalidInput for values of another number of points or triangles than the mesh
/// has.
void requireValuesOf(const TriangleMesh& mesh, const Thickness& thickness);

} // namespace medial

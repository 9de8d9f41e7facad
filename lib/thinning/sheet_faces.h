#pragma once

#include "thinning/axis_samples.h"
#include "thinning/cubical_complex.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Faces of a complex, split into sheets and strips. A face is part of a sheet if one of its
/// corners is an inner point: no face ends at an edge of that corner, and the samples of the faces
/// around it do not lie on a line; or if its bisector is exact and such a sheet goes on in it,
/// through edges, or all faces at its corners are on the same sheet, as in small pieces near the
/// minimum angle. The others are faces around curves and points, and stand for these.
struct SheetSplit
{
  std::vector<CubeCell> sheets;
  std::vector<CubeCell> strips;
};

/// @param samples of all the faces to split.
/// @param exact for each sample not 0 if no site is nearer than its pair: between facets of a thin
///   part the others lie in all directions.
SheetSplit splitSheets(const CubicalComplex& complex, const std::vector<CubeCell>& faces,
  const AxisSamples& samples, const std::vector<std::uint8_t>& exact);

/// The same, in the complex that the faces form on their own.
SheetSplit splitSheets(const glm::ivec3& size, const std::vector<CubeCell>& faces,
  const AxisSamples& samples, const std::vector<std::uint8_t>& exact);

} // namespace medial

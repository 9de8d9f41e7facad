#pragma once

#include "axis/bisector.h"
#include "medial/representation.h"
#include "thinning/axis_samples.h"
#include "thinning/cubical_complex.h"
#include "thinning/voxel_solid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Cells of the dual mesh.
struct ThinnedAxis
{
  BisectorPoints points; ///< distinct
  std::vector<std::array<std::int64_t, 4>> quads;
  std::vector<std::array<std::int64_t, 2>> lines;
  std::vector<std::int64_t> vertices;
};

/// What thinning left, as cells of the dual mesh: a quad for each face, a line for each edge of no
/// face, a vertex for each corner of neither, all with one point for each corner.
///
/// Where selected faces are there a point is placed as surfacePoints() does. Elsewhere it lies at
/// the mean of the samples around it: of faces that are there without being selected, or selected
/// ones that are gone, or else of the grid edges with the widest separation angles. For
/// Representation::Faces it is the middle of its grid cell. Points stay at least kCellMargin inside
/// of their grid cells, which makes them distinct and every quad have an area, so that the cells
/// have the topology of the complex.
///
/// @param samples receives those that are missing.
ThinnedAxis thinnedAxis(const CubicalComplex& complex, const DepthField& depth,
  const SampleContext& context, Representation representation, AxisSamples& samples);

/// In frame units along the finest axis.
constexpr double kCellMargin = 0.02;

} // namespace medial

#pragma once

#include "axis/bisector.h"
#include "axis/sheets/sheet_selection.h"
#include "medial/representation.h"
#include "thinning/axis_samples.h"
#include "thinning/cubical_complex.h"
#include "thinning/voxel_solid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Cells of a dual mesh.
struct ThinnedAxis
{
  BisectorPoints points;             ///< distinct
  std::vector<glm::ivec3> gridCells; ///< of the points, from the first grid point on
  /// For each point that is on a selected face the vertex of the selection's samples in its grid
  /// cell; kNoVertex for others.
  std::vector<std::size_t> origins;
  std::vector<std::array<std::int64_t, 4>> quads;
  std::vector<std::array<std::int64_t, 2>> lines;
  std::vector<std::int64_t> vertices;
};

/// The samples of a solid that are selected.
struct SelectedSamples
{
  const SheetSelection& sheets;
  const std::vector<std::size_t>& indices; ///< in the selection, of the first samples of the solid
};

/// Whether selected faces are left around a corner.
/// @param samples of the selected faces, and no others around it.
bool isOnSheet(const CubicalComplex& complex, const AxisSamples& samples, CubeCell vertex);

/// Gives corners of what thinning left their points, without cells.
///
/// Where selected faces are left, a point is placed as by surfacePoints(). Elsewhere it lies at the
/// mean of the samples around it: those of faces that are left without being selected, or of
/// selected faces that are gone, or else of the grid edges with the widest separation angles. For
/// Representation::Faces it is the middle of its grid cell. Points stay at least kCellMargin inside
/// of their grid cells, which makes them distinct and every quad have an area, so that the cells
/// have the topology of the complex.
///
/// @param vertices corners of the complex, ascending. The complex has all that is left around them,
///   and the depths are known there.
/// @param samples receives those that are missing.
ThinnedAxis pointsOfCorners(const CubicalComplex& complex, std::vector<CubeCell> vertices,
  const DepthField& depth, const SampleContext& context, const SelectedSamples& selected,
  Representation representation, AxisSamples& samples);

/// Turns what thinning left into cells of the dual mesh: a quad for each face, a line for each edge
/// of no face, and a vertex for each corner of neither. Those with a corner that has no point are
/// left out.
/// @param vertices the corners of the axis's points, ascending.
void addCells(const CubicalComplex& complex, const std::vector<CubeCell>& vertices,
  ThinnedAxis& axis);

/// Does both for all corners.
ThinnedAxis thinnedAxis(const CubicalComplex& complex, const DepthField& depth,
  const SampleContext& context, const SelectedSamples& selected, Representation representation,
  AxisSamples& samples);

/// Margin in local units along the finest axis.
constexpr double kCellMargin = 0.02;

} // namespace medial

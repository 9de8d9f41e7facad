#pragma once

#include "axis/bisector.h"
#include "medial/medial_axis.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Where the points and polygons of cells come from.
struct CellOrigins
{
  std::vector<std::int64_t> standsFor; ///< for each point that was given the one in its place
  std::vector<std::size_t> points;     ///< for each point that is left which it was, ascending
  std::vector<std::size_t> quads;      ///< for each quad that is left which it was, ascending
  std::vector<std::size_t> triangles;  ///< for each triangle the quad that it was, ascending
};

/// Contracts the short edges of quads and sorts the quads by what is left of them: quads,
/// triangles, lines and vertices without zero area, repeated corners or duplicates. Sets the cells
/// of `axis` and removes points that no cell uses from `points`.
///
/// Edges that end at a moved point count as short up to most of a grid step, so that fins around a
/// curve become the lines of the curve and leave no slivers.
///
/// @param origins receives where they come from; may be null.
void buildCells(const std::vector<std::array<std::int64_t, 4>>& quads, BisectorPoints& points,
  MedialAxis& axis, CellOrigins* origins = nullptr);

/// Makes a vertex for each point; equal points become one.
void buildVertices(BisectorPoints& points, MedialAxis& axis, CellOrigins* origins = nullptr);

} // namespace medial

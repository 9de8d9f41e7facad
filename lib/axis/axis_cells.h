#pragma once

#include "axis/bisector.h"
#include "medial/medial_axis.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Contracts the short edges of quads and sorts the quads by what is left of them: quads,
/// triangles, lines and vertices without zero area, repeated corners or duplicates. Sets the cells
/// of `axis` and removes points that no cell uses from `points`.
///
/// Edges that end at a moved point count as short up to most of a grid step, so that fins around a
/// curve become the lines of the curve and leave no slivers.
void buildCells(const std::vector<std::array<std::int64_t, 4>>& quads, BisectorPoints& points,
  MedialAxis& axis);

/// Makes a vertex for each point; equal points become one.
void buildVertices(BisectorPoints& points, MedialAxis& axis);

} // namespace medial

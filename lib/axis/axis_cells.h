#pragma once

#include "axis/bisector.h"
#include "medial/medial_axis.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Contracts the short edges of quads and sorts the quads by what is left of them: quads,
/// triangles, lines and vertices without zero area, repeated corners or duplicates. Points that no
/// cell uses are removed from `points`; the cells of `axis` are set.
///
/// Edges that end at a moved point count as short up to most of a grid step, so that fins around a
/// curve leave the lines of the curve and no slivers.
void buildCells(const std::vector<std::array<std::int64_t, 4>>& quads, BisectorPoints& points,
  MedialAxis& axis);

/// A vertex for each point; equal ones become one.
void buildVertices(BisectorPoints& points, MedialAxis& axis);

} // namespace medial

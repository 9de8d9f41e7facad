#include "thinning/rim_finish.h"

#include "axis/dual_mesh.h"
#include "axis/sheets/border_rims.h"
#include "axis/sheets/crease_rims.h"
#include "thinning/sound_cells.h"

#include <algorithm>

namespace medial
{

std::vector<EdgeTable::Edge> selectedRims(const ThinnedAxis& axis)
{
  const std::vector<std::size_t>& origins = axis.origins;
  std::vector<EdgeTable::Edge> rims = rimEdges(axis.gridCells, axis.quads);
  rims.erase(std::remove_if(rims.begin(), rims.end(),
               [&](const EdgeTable::Edge& edge)
               { return origins[edge[0]] == kNoVertex || origins[edge[1]] == kNoVertex; }),
    rims.end());
  return rims;
}

void finishRims(const AxisGeometry& geometry, const SheetSelection& sheets, ThinnedAxis& axis)
{
  const std::vector<BisectorPoint> before = axis.points.points;
  const std::vector<std::size_t> elsewhere =
    moveToBorders(geometry, sheets, selectedRims(axis), axis.origins, axis.points);
  extendRims(geometry, elsewhere, axis.points);
  keepCellsSound(before, axis);
}

} // namespace medial

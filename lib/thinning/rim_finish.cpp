#include "thinning/rim_finish.h"

#include "axis/border_rims.h"
#include "axis/crease_rims.h"
#include "axis/dual_mesh.h"
#include "thinning/axis_samples.h"
#include "thinning/sound_cells.h"

#include <algorithm>

namespace medial
{
namespace
{

constexpr std::size_t kNoOrigin = static_cast<std::size_t>(-1);

/// Returns for each point of an axis the vertex of the samples in its grid cell, if it is on a
/// selected face.
std::vector<std::size_t> originsOf(const SheetSelection& sheets,
  const std::vector<std::size_t>& selected, const ThinnedAxis& axis)
{
  std::vector<std::size_t> origins(axis.selected.size(), kNoOrigin);
  const DualMesh& mesh = sheets.part.mesh;
  for (std::size_t p = 0; p < origins.size(); ++p)
  {
    if (axis.selected[p] != AxisSamples::kNone)
    {
      const auto& corners = mesh.corners[selected[static_cast<std::size_t>(axis.selected[p])]];
      const auto corner = std::find_if(corners.begin(), corners.end(),
        [&](std::int64_t vertex) { return mesh.cells[vertex] == axis.gridCells[p]; });
      origins[p] = corner == corners.end() ? kNoOrigin : sheets.part.origins[*corner];
    }
  }
  return origins;
}

} // namespace

void finishRims(const AxisGeometry& geometry, const SheetSelection& sheets,
  const std::vector<std::size_t>& selected, ThinnedAxis& axis)
{
  const std::vector<std::size_t> origins = originsOf(sheets, selected, axis);
  std::vector<EdgeTable::Edge> rims = rimEdges(axis.gridCells, axis.quads);
  rims.erase(std::remove_if(rims.begin(), rims.end(),
               [&](const EdgeTable::Edge& edge)
               { return origins[edge[0]] == kNoOrigin || origins[edge[1]] == kNoOrigin; }),
    rims.end());
  const std::vector<BisectorPoint> before = axis.points.points;
  const std::vector<std::size_t> elsewhere =
    moveToBorders(geometry, sheets, rims, origins, axis.points);
  extendRims(geometry, elsewhere, axis.points);
  keepCellsSound(before, axis);
}

} // namespace medial

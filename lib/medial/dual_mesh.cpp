#include "medial/medial/dual_mesh.h"

#include <tbb/parallel_sort.h>

#include <tuple>

namespace medial
{
namespace
{

/// Corner `corner` of the quad around `crossing` lies in a cell.
struct CornerKey
{
  glm::ivec3 cell;
  bool inside;
  std::size_t crossing;
  int corner;
};

bool before(const CornerKey& a, const CornerKey& b)
{
  return std::tie(a.cell.z, a.cell.y, a.cell.x, a.inside, a.crossing, a.corner) <
    std::tie(b.cell.z, b.cell.y, b.cell.x, b.inside, b.crossing, b.corner);
}

bool sameVertex(const CornerKey& a, const CornerKey& b)
{
  return a.cell == b.cell && a.inside == b.inside;
}

/// Cells around a crossed edge, in cyclic order.
std::array<glm::ivec3, 4> cellsAround(const Crossing& crossing)
{
  glm::ivec3 u(0);
  glm::ivec3 v(0);
  u[(crossing.axis + 1) % 3] = 1;
  v[(crossing.axis + 2) % 3] = 1;
  return { crossing.voxel - u - v, crossing.voxel - v, crossing.voxel, crossing.voxel - u };
}

bool insideGrid(const glm::ivec3& cell, const Extent& extent)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (cell[axis] < extent.min[axis] || cell[axis] >= extent.max[axis])
    {
      return false;
    }
  }
  return true;
}

} // namespace

DualMesh dualMesh(const std::vector<Crossing>& crossings, const Extent& extent)
{
  std::vector<CornerKey> corners;
  corners.reserve(4 * crossings.size());
  for (std::size_t c = 0; c < crossings.size(); ++c)
  {
    const std::array<glm::ivec3, 4> cells = cellsAround(crossings[c]);
    for (int i = 0; i < 4; ++i)
    {
      corners.push_back({ cells[i], crossings[c].inside, c, i });
    }
  }
  tbb::parallel_sort(corners.begin(), corners.end(), before);
  DualMesh mesh;
  mesh.incident.reserve(corners.size());
  std::vector<std::array<std::int64_t, 4>> quads(crossings.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (i == 0 || !sameVertex(corners[i], corners[i - 1]))
    {
      mesh.cells.push_back(corners[i].cell);
      mesh.offsets.push_back(mesh.incident.size());
    }
    mesh.incident.push_back(corners[i].crossing);
    mesh.offsets.back() = mesh.incident.size();
    quads[corners[i].crossing][corners[i].corner] =
      static_cast<std::int64_t>(mesh.cells.size()) - 1;
  }
  for (const auto& quad : quads)
  {
    if (insideGrid(mesh.cells[quad[0]], extent) && insideGrid(mesh.cells[quad[2]], extent))
    {
      mesh.quads.push_back(quad);
    }
  }
  return mesh;
}

} // namespace medial

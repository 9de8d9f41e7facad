#include "axis/dual_mesh.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

namespace medial
{
namespace
{

/// A corner of the quad around a crossing, and its vertex, given by a cell and a side of the
/// surface.
struct CornerKey
{
  std::uint64_t vertex;
  std::uint64_t corner; ///< four times the crossing, plus the corner's number

  bool operator<(const CornerKey& other) const
  {
    return vertex != other.vertex ? vertex < other.vertex : corner < other.corner;
  }
};

/// Numbers cells by z, y, x, including those half outside the grid.
class CellNumbers
{
public:
  explicit CellNumbers(const Extent& extent)
    : first_(extent.min[0] - 1, extent.min[1] - 1, extent.min[2] - 1)
    , width_(extent.size(0) + 1)
    , height_(extent.size(1) + 1)
  {
  }

  std::uint64_t number(const glm::ivec3& cell, bool inside) const
  {
    const glm::ivec3 offset = cell - first_;
    return 2 * ((static_cast<std::uint64_t>(offset.z) * height_ + offset.y) * width_ + offset.x) +
      (inside ? 1 : 0);
  }

private:
  glm::ivec3 first_;
  std::uint64_t width_;
  std::uint64_t height_;
};

/// Returns the cells around a crossed edge, in cyclic order.
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
  const CellNumbers numbers(extent);
  std::vector<CornerKey> corners(4 * crossings.size());
  tbb::parallel_for(std::size_t{ 0 }, crossings.size(),
    [&](std::size_t c)
    {
      const std::array<glm::ivec3, 4> cells = cellsAround(crossings[c]);
      for (std::size_t i = 0; i < 4; ++i)
      {
        corners[4 * c + i] = { numbers.number(cells[i], crossings[c].inside), 4 * c + i };
      }
    });
  tbb::parallel_sort(corners.begin(), corners.end());
  DualMesh mesh;
  mesh.incident.reserve(corners.size());
  mesh.corners.resize(crossings.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const std::uint64_t crossing = corners[i].corner / 4;
    const std::uint64_t corner = corners[i].corner % 4;
    if (i == 0 || corners[i].vertex != corners[i - 1].vertex)
    {
      mesh.cells.push_back(cellsAround(crossings[crossing])[corner]);
      mesh.offsets.push_back(mesh.incident.size());
    }
    mesh.incident.push_back(crossing);
    mesh.offsets.back() = mesh.incident.size();
    mesh.corners[crossing][corner] = static_cast<std::int64_t>(mesh.cells.size()) - 1;
  }
  return mesh;
}

DualSubmesh submesh(const DualMesh& mesh, const std::vector<std::uint8_t>& kept)
{
  std::vector<std::size_t> target(kept.size());
  std::size_t count = 0;
  for (std::size_t c = 0; c < kept.size(); ++c)
  {
    target[c] = count;
    count += kept[c] != 0 ? 1 : 0;
  }
  DualSubmesh part;
  part.mesh.incident.reserve(4 * count);
  part.mesh.corners.reserve(count);
  std::vector<std::int64_t> vertices(mesh.cells.size());
  for (std::size_t v = 0; v < mesh.cells.size(); ++v)
  {
    for (std::size_t i = mesh.offsets[v]; i < mesh.offsets[v + 1]; ++i)
    {
      if (kept[mesh.incident[i]] != 0)
      {
        part.mesh.incident.push_back(target[mesh.incident[i]]);
      }
    }
    vertices[v] = static_cast<std::int64_t>(part.origins.size());
    if (part.mesh.incident.size() > part.mesh.offsets.back())
    {
      part.mesh.offsets.push_back(part.mesh.incident.size());
      part.mesh.cells.push_back(mesh.cells[v]);
      part.origins.push_back(v);
    }
  }
  for (std::size_t c = 0; c < kept.size(); ++c)
  {
    if (kept[c] != 0)
    {
      part.mesh.corners.push_back(mesh.corners[c]);
      for (std::int64_t& corner : part.mesh.corners.back())
      {
        corner = vertices[corner];
      }
    }
  }
  return part;
}

std::vector<std::array<std::int64_t, 4>> quadsWithin(const DualMesh& mesh, const Extent& extent)
{
  std::vector<std::array<std::int64_t, 4>> quads;
  quads.reserve(mesh.corners.size());
  for (const auto& quad : mesh.corners)
  {
    if (insideGrid(mesh.cells[quad[0]], extent) && insideGrid(mesh.cells[quad[2]], extent))
    {
      quads.push_back(quad);
    }
  }
  return quads;
}

std::vector<EdgeTable::Edge> rimEdges(const std::vector<std::array<std::int64_t, 4>>& quads,
  std::size_t vertexCount)
{
  std::vector<EdgeTable::Edge> edges;
  edges.reserve(4 * quads.size());
  for (const auto& quad : quads)
  {
    addEdges(quad, edges);
  }
  std::vector<EdgeTable::Edge> rims;
  EdgeTable(edges, vertexCount)
    .forEach(
      [&](const EdgeTable::Edge& edge, std::size_t count)
      {
        if (count == 1)
        {
          rims.push_back(edge);
        }
      });
  return rims;
}

} // namespace medial

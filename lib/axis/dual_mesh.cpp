#include "axis/dual_mesh.h"

#include "base/extents.h"
#include "base/huge_pages.h"
#include "base/sorted_set.h"

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{

/// Number of vertices or crossings that a thread takes at once.
constexpr std::size_t kTogether = 4096;

/// Returns the cells around a crossed edge, in cyclic order.
std::array<glm::ivec3, 4> cellsAround(const Crossing& crossing)
{
  glm::ivec3 u(0);
  glm::ivec3 v(0);
  u[(crossing.axis + 1) % 3] = 1;
  v[(crossing.axis + 2) % 3] = 1;
  return { crossing.voxel - u - v, crossing.voxel - v, crossing.voxel, crossing.voxel - u };
}

/// The corners of quads around crossings that lie in one row of cells, by where the row of the
/// crossings is relative to it: at (0, 0), (1, 0), (0, 1) or (1, 1).
class RowCorners
{
public:
  struct Corner
  {
    int number; ///< as in cellsAround()
    int x;      ///< of its cell, relative to the crossing
  };

  RowCorners()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::array<glm::ivec3, 4> cells = cellsAround({ glm::ivec3(0), axis, -1, -1, false });
      for (int i = 0; i < 4; ++i)
      {
        std::vector<Corner>& corners = corners_[axis][-cells[i].y - 2 * cells[i].z];
        corners.push_back({ i, cells[i].x });
      }
    }
  }

  /// @param row y + 2 z of the row.
  const std::vector<Corner>& of(int axis, int row) const { return corners_[axis][row]; }

private:
  std::array<std::array<std::vector<Corner>, 4>, 3> corners_;
};

/// The crossings by the rows along x of their grid points. They mostly come so, but engines may
/// leave some of a row for later.
class CrossingRows
{
public:
  CrossingRows(const std::vector<Crossing>& crossings, const Extent& extent)
    : crossings_(crossings)
    , min_(extent.min[1], extent.min[2])
    , size_(extent.size(1), extent.size(2))
    , ends_(static_cast<std::size_t>(size_.x) * size_.y + 1, 0)
    , order_(crossings.size())
  {
    for (const Crossing& crossing : crossings)
    {
      ++ends_[this->rowOf(crossing.voxel) + 1];
    }
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    for (std::size_t c = 0; c < crossings.size(); ++c)
    {
      order_[ends_[this->rowOf(crossings[c].voxel)]++] = static_cast<std::uint32_t>(c);
    }
  }

  /// Calls visit(corner, crossing, x) for every corner of a quad in a row of cells, with the cell's
  /// place along x.
  template <typename Visit>
  void forEachCorner(int y, int z, const Visit& visit) const
  {
    for (int row = 0; row < 4; ++row)
    {
      const glm::ivec2 at = glm::ivec2(y + row % 2, z + row / 2) - min_;
      if (at.x < 0 || at.y < 0 || at.x >= size_.x || at.y >= size_.y)
      {
        continue;
      }
      const std::size_t r = static_cast<std::size_t>(at.y) * size_.x + at.x;
      for (std::uint32_t k = r > 0 ? ends_[r - 1] : 0; k < ends_[r]; ++k)
      {
        const Crossing& crossing = crossings_[order_[k]];
        for (const RowCorners::Corner& corner : corners_.of(crossing.axis, row))
        {
          visit(4 * static_cast<std::uint64_t>(order_[k]) + corner.number, crossing,
            crossing.voxel.x + corner.x);
        }
      }
    }
  }

private:
  std::size_t rowOf(const glm::ivec3& voxel) const
  {
    return static_cast<std::size_t>(voxel.z - min_.y) * size_.x + (voxel.y - min_.x);
  }

  const std::vector<Crossing>& crossings_;
  RowCorners corners_;
  glm::ivec2 min_;                   ///< y, z
  glm::ivec2 size_;                  ///< likewise
  std::vector<std::uint32_t> ends_;  ///< of the rows in order_
  std::vector<std::uint32_t> order_; ///< row by row
};

/// The corners of the quads around crossings, by rows of cells along x.
class CornerRows
{
public:
  CornerRows(const std::vector<Crossing>& crossings, const Extent& extent)
    : crossings_(crossings, extent)
    , first_(extent.min[0] - 1, extent.min[1] - 1, extent.min[2] - 1)
    , height_(extent.size(1) + 1)
    , begins_(static_cast<std::size_t>(height_) * (extent.size(2) + 1) + 1, 0)
    , vertices_(begins_.size(), 0)
    , corners_(4 * crossings.size())
  {
    this->fill();
    this->sort();
  }

  DualMesh mesh() const
  {
    DualMesh mesh;
    resizeLarge(mesh.cells, vertices_.back());
    resizeLarge(mesh.offsets, vertices_.back() + 1);
    resizeLarge(mesh.incident, corners_.size());
    resizeLarge(mesh.corners, corners_.size() / 4);
    this->inRows([&](std::size_t row) { this->addVertices(row, mesh); });
    return mesh;
  }

private:
  // A corner is given by its cell along x, its side of the surface, four times its crossing, and
  // its number: so those of a vertex are together, in the order of the crossings.
  static constexpr int kCornerBits = 32;

  /// Calls visit(row) for every row of cells, on all threads.
  template <typename Visit>
  void inRows(const Visit& visit) const
  {
    constexpr std::size_t kRows = 64; // many are empty
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, begins_.size() - 1, kRows),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        for (std::size_t row = range.begin(); row != range.end(); ++row)
        {
          visit(row);
        }
      });
  }

  template <typename Visit>
  void forEachCorner(std::size_t row, const Visit& visit) const
  {
    const auto r = static_cast<int>(row);
    crossings_.forEachCorner(first_.y + r % height_, first_.z + r / height_, visit);
  }

  void fill()
  {
    this->inRows(
      [&](std::size_t row) {
        this->forEachCorner(row, [&](std::uint64_t, const Crossing&, int) { ++begins_[row + 1]; });
      });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    this->inRows(
      [&](std::size_t row)
      {
        std::size_t next = begins_[row];
        this->forEachCorner(row,
          [&](std::uint64_t corner, const Crossing& crossing, int x)
          {
            const auto vertex =
              static_cast<std::uint64_t>(2 * (x - first_.x)) + (crossing.inside ? 1 : 0);
            corners_[next++] = vertex << kCornerBits | corner;
          });
      });
  }

  /// Sorts every row, and counts the vertices before it.
  void sort()
  {
    this->inRows(
      [&](std::size_t row)
      {
        const std::size_t begin = begins_[row];
        const std::size_t end = begins_[row + 1];
        std::sort(corners_.begin() + static_cast<std::ptrdiff_t>(begin),
          corners_.begin() + static_cast<std::ptrdiff_t>(end));
        for (std::size_t i = begin; i < end; ++i)
        {
          vertices_[row + 1] += this->startsVertex(row, i) ? 1 : 0;
        }
      });
    std::partial_sum(vertices_.begin(), vertices_.end(), vertices_.begin());
  }

  bool startsVertex(std::size_t row, std::size_t i) const
  {
    return i == begins_[row] || corners_[i] >> kCornerBits != corners_[i - 1] >> kCornerBits;
  }

  void addVertices(std::size_t row, DualMesh& mesh) const
  {
    std::size_t next = vertices_[row];
    for (std::size_t i = begins_[row]; i < begins_[row + 1]; ++i)
    {
      if (this->startsVertex(row, i))
      {
        const glm::ivec3 offset(static_cast<int>(corners_[i] >> kCornerBits) / 2,
          static_cast<int>(row % height_), static_cast<int>(row / height_));
        mesh.cells[next++] = first_ + offset;
      }
      const std::uint64_t corner = corners_[i] & ((std::uint64_t{ 1 } << kCornerBits) - 1);
      mesh.incident[i] = static_cast<std::uint32_t>(corner / 4);
      mesh.corners[corner / 4][corner % 4] = static_cast<std::uint32_t>(next - 1);
      mesh.offsets[next] = i + 1;
    }
  }

  CrossingRows crossings_;
  glm::ivec3 first_;
  int height_;
  std::vector<std::size_t> begins_;    ///< of the rows in corners_
  std::vector<std::size_t> vertices_;  ///< for each row the number of vertices before it
  std::vector<std::uint64_t> corners_; ///< row by row
};

} // namespace

DualMesh dualMesh(const std::vector<Crossing>& crossings, const Extent& extent)
{
  return CornerRows(crossings, extent).mesh();
}

DualSubmesh submesh(const DualMesh& mesh, const std::vector<std::uint8_t>& kept)
{
  std::vector<std::uint32_t> target(kept.size() + 1);
  for (std::size_t c = 0; c < kept.size(); ++c)
  {
    target[c + 1] = target[c] + (kept[c] != 0 ? 1 : 0);
  }
  // For each vertex how many vertices and crossings come before it.
  std::vector<std::uint32_t> vertices(mesh.cells.size() + 1);
  std::vector<std::size_t> incident(mesh.cells.size() + 1);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.cells.size(), kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t v = range.begin(); v != range.end(); ++v)
      {
        const auto count =
          std::count_if(mesh.incident.begin() + static_cast<std::ptrdiff_t>(mesh.offsets[v]),
            mesh.incident.begin() + static_cast<std::ptrdiff_t>(mesh.offsets[v + 1]),
            [&](std::size_t crossing) { return kept[crossing] != 0; });
        incident[v + 1] = static_cast<std::size_t>(count);
      }
    });
  for (std::size_t v = 0; v < mesh.cells.size(); ++v)
  {
    vertices[v + 1] = vertices[v] + (incident[v + 1] != 0 ? 1 : 0);
    incident[v + 1] += incident[v];
  }
  DualSubmesh part;
  resizeLarge(part.mesh.incident, incident.back());
  resizeLarge(part.mesh.corners, target.back());
  resizeLarge(part.mesh.offsets, vertices.back() + 1);
  resizeLarge(part.mesh.cells, vertices.back());
  resizeLarge(part.origins, vertices.back());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.cells.size(), kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t v = range.begin(); v != range.end(); ++v)
      {
        if (vertices[v] == vertices[v + 1])
        {
          continue;
        }
        std::size_t next = incident[v];
        for (std::size_t i = mesh.offsets[v]; i < mesh.offsets[v + 1]; ++i)
        {
          const std::size_t crossing = mesh.incident[i];
          if (kept[crossing] != 0)
          {
            part.mesh.incident[next++] = target[crossing];
          }
        }
        part.mesh.offsets[vertices[v + 1]] = next;
        part.mesh.cells[vertices[v]] = mesh.cells[v];
        part.origins[vertices[v]] = v;
      }
    });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, kept.size(), kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t c = range.begin(); c != range.end(); ++c)
      {
        for (std::size_t i = 0; kept[c] != 0 && i < 4; ++i)
        {
          part.mesh.corners[target[c]][i] = vertices[mesh.corners[c][i]];
        }
      }
    });
  return part;
}

bool isWithin(const DualMesh& mesh, const std::array<std::uint32_t, 4>& quad, const Extent& extent)
{
  // These two are at opposite corners.
  return hasCell(extent, mesh.cells[quad[0]]) && hasCell(extent, mesh.cells[quad[2]]);
}

std::vector<std::array<std::int64_t, 4>> quadsWithin(const DualMesh& mesh, const Extent& extent)
{
  std::vector<std::array<std::int64_t, 4>> quads;
  reserveLarge(quads, mesh.corners.size());
  for (const auto& quad : mesh.corners)
  {
    if (isWithin(mesh, quad, extent))
    {
      quads.push_back({ quad[0], quad[1], quad[2], quad[3] });
    }
  }
  return quads;
}

std::vector<EdgeTable::Edge> rimEdges(const std::vector<glm::ivec3>& cells,
  const std::vector<std::array<std::int64_t, 4>>& quads)
{
  // Edges join neighbouring cells. The cell with the lower number comes first along their axis, and
  // of its neighbours those along x, y, z follow each other.
  struct FromCell
  {
    std::array<std::uint8_t, 3> quads{}; ///< at the edges along x, y, z
    std::array<std::int32_t, 3> ends;
  };
  std::vector<FromCell> edges(cells.size());
  for (const auto& quad : quads)
  {
    for (std::size_t i = 0; i < quad.size(); ++i)
    {
      const auto [low, high] = std::minmax(quad[i], quad[(i + 1) % quad.size()]);
      const glm::ivec3 along = cells[high] - cells[low];
      const int axis = along.x != 0 ? 0 : along.y != 0 ? 1 : 2;
      ++edges[low].quads[axis];
      edges[low].ends[axis] = static_cast<std::int32_t>(high);
    }
  }
  std::vector<EdgeTable::Edge> rims;
  for (std::size_t low = 0; low < edges.size(); ++low)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (edges[low].quads[axis] == 1)
      {
        rims.push_back({ static_cast<std::int64_t>(low), edges[low].ends[axis] });
      }
    }
  }
  return rims;
}

std::vector<std::size_t> verticesOn(const std::vector<EdgeTable::Edge>& rims)
{
  std::vector<std::size_t> vertices;
  vertices.reserve(2 * rims.size());
  for (const EdgeTable::Edge& edge : rims)
  {
    for (const std::int64_t vertex : edge)
    {
      vertices.push_back(static_cast<std::size_t>(vertex));
    }
  }
  makeSet(vertices);
  return vertices;
}

} // namespace medial

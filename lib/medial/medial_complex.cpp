#include "medial/medial/medial_complex.h"

#include <tbb/parallel_sort.h>

#include <tuple>

namespace medial
{
namespace
{

/// Corner `corner` of crossing `crossing` lies on the lattice point `key`.
struct CornerKey
{
  glm::ivec3 key;
  std::size_t crossing;
  int corner;
};

bool before(const CornerKey& a, const CornerKey& b)
{
  return std::tie(a.key.z, a.key.y, a.key.x, a.crossing, a.corner) <
    std::tie(b.key.z, b.key.y, b.key.x, b.crossing, b.corner);
}

/// Lattice cells around a crossed edge, in cyclic order: cell (i,j,k) spans the grid points from
/// (i,j,k) to (i+1,j+1,k+1).
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

/// Joins equal lattice points: each becomes a point with the crossings that meet there, and each
/// crossing a quad.
MedialComplex joinCorners(const std::vector<Crossing>& crossings, const Extent& extent,
  std::vector<glm::ivec3>& lattice)
{
  std::vector<CornerKey> corners;
  corners.reserve(4 * crossings.size());
  for (std::size_t c = 0; c < crossings.size(); ++c)
  {
    const std::array<glm::ivec3, 4> cells = cellsAround(crossings[c]);
    for (int i = 0; i < 4; ++i)
    {
      corners.push_back({ cells[i], c, i });
    }
  }
  tbb::parallel_sort(corners.begin(), corners.end(), before);
  MedialComplex complex;
  std::vector<std::array<std::int64_t, 4>> quads(crossings.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (i == 0 || corners[i].key != corners[i - 1].key)
    {
      lattice.push_back(corners[i].key);
      complex.offsets.push_back(complex.incident.size());
    }
    complex.incident.push_back(corners[i].crossing);
    complex.offsets.back() = complex.incident.size();
    quads[corners[i].crossing][corners[i].corner] = static_cast<std::int64_t>(lattice.size()) - 1;
  }
  for (const auto& quad : quads)
  {
    if (insideGrid(lattice[quad[0]], extent) && insideGrid(lattice[quad[2]], extent))
    {
      complex.quads.push_back(quad);
    }
  }
  return complex;
}

} // namespace

MedialComplex pointComplex(const std::vector<glm::dvec3>& bisectorPoints)
{
  MedialComplex complex;
  complex.points = bisectorPoints;
  for (std::size_t i = 0; i < bisectorPoints.size(); ++i)
  {
    complex.incident.push_back(i);
    complex.offsets.push_back(i + 1);
    complex.vertices.push_back(static_cast<std::int64_t>(i));
  }
  return complex;
}

MedialComplex surfaceComplex(const std::vector<Crossing>& crossings,
  const std::vector<glm::dvec3>& bisectorPoints, const Extent& extent)
{
  std::vector<glm::ivec3> cells;
  MedialComplex complex = joinCorners(crossings, extent, cells);
  complex.points.reserve(cells.size());
  for (std::size_t p = 0; p < cells.size(); ++p)
  {
    glm::dvec3 sum(0.0);
    for (std::size_t i = complex.offsets[p]; i < complex.offsets[p + 1]; ++i)
    {
      sum += bisectorPoints[complex.incident[i]];
    }
    complex.points.push_back(
      sum / static_cast<double>(complex.offsets[p + 1] - complex.offsets[p]));
  }
  return complex;
}

MedialComplex faceComplex(const std::vector<Crossing>& crossings, const GridFrame& frame,
  const Extent& extent)
{
  std::vector<glm::ivec3> cells;
  MedialComplex complex = joinCorners(crossings, extent, cells);
  complex.points.reserve(cells.size());
  for (const glm::ivec3& cell : cells)
  {
    complex.points.push_back(frame.sample(glm::dvec3(cell) + 0.5));
  }
  return complex;
}

} // namespace medial

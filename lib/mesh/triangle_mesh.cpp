#include "medial/triangle_mesh.h"

#include "base/id_limits.h"
#include "base/vectors.h"
#include "medial/error.h"
#include "mesh/cell_check.h"
#include "mesh/polygon_triangulation.h"
#include "mesh/position_hash.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace medial
{

namespace
{

/// Height over longest side below which the direction of a normal is rounding noise.
constexpr double kMinRelativeHeight = 1e-12;

/// Finds points by the bits of their coordinates: a hash table with linear probing.
class PointWelder
{
public:
  explicit PointWelder(std::size_t expected)
  {
    std::size_t capacity = 16;
    while (capacity < 2 * expected)
    {
      capacity *= 2;
    }
    slots_.assign(capacity, -1);
  }

  /// Returns the index in `points` of a point equal to `point`; appends the point if there is none.
  int insert(const Point3& point, std::vector<Point3>& points)
  {
    // Adding zero turns -0 into 0.
    const Point3 key = { point[0] + 0.0, point[1] + 0.0, point[2] + 0.0 };
    std::size_t slot = hashOf(key) & (slots_.size() - 1);
    while (slots_[slot] >= 0 && points[slots_[slot]] != key)
    {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    if (slots_[slot] < 0)
    {
      slots_[slot] = static_cast<int>(points.size());
      points.push_back(key);
    }
    return slots_[slot];
  }

private:
  std::vector<int> slots_;
};

/// Splits strips; two corners of every other triangle are swapped, since it runs backwards.
CellList trianglesOf(const CellList& strips)
{
  CellList triangles;
  for (std::int64_t strip = 0; strip < strips.size(); ++strip)
  {
    const std::int64_t* ids = strips.connectivity.data() + strips.offsets[strip];
    const std::int64_t count = strips.offsets[strip + 1] - strips.offsets[strip];
    for (std::int64_t i = 0; i + 2 < count; ++i)
    {
      const std::int64_t odd = i % 2;
      triangles.append({ ids[i], ids[i + 1 + odd], ids[i + 2 - odd] }, strips.ids[strip]);
    }
  }
  return triangles;
}

void requireConsistent(const CellList& cells, const char* name)
{
  const auto& offsets = cells.offsets;
  if (offsets.size() != cells.ids.size() + 1 || offsets.front() != 0 ||
    offsets.back() != static_cast<std::int64_t>(cells.connectivity.size()) ||
    !std::is_sorted(offsets.begin(), offsets.end()))
  {
    throw Error(ErrorCode::InvalidInput,
      std::string("the offsets of the ") + name + " do not fit their ids and connectivity");
  }
}

[[noreturn]] void throwUnusable(std::size_t index, const Point3& point)
{
  const bool finite = std::all_of(point.begin(), point.end(),
    [](double coordinate) { return std::isfinite(coordinate); });
  std::ostringstream message;
  message << "point " << index << " has a coordinate that is ";
  if (finite)
  {
    message << "beyond " << kMaxCoordinate << " in magnitude: (";
  }
  else
  {
    message << "not finite: (";
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // The sign of a NaN means nothing, but streams print it.
    message << (axis > 0 ? ", " : "")
            << (std::isnan(point[axis]) ? std::abs(point[axis]) : point[axis]);
  }
  message << ')';
  throw Error(ErrorCode::InvalidInput, message.str());
}

[[noreturn]] void throwBadPoint(std::int64_t cell, std::int64_t point, std::size_t count)
{
  std::ostringstream message;
  message << "cell " << cell << " names point " << point << ", but there are only " << count
          << " points";
  throw Error(ErrorCode::InvalidInput, message.str());
}

class MeshBuilder
{
public:
  explicit MeshBuilder(const MeshInput& input)
    : input_(input)
  {
  }

  TriangleMesh build()
  {
    requireConsistent(input_.strips, "strips");
    const CellList stripTriangles = trianglesOf(input_.strips);
    checkSizes(stripTriangles);
    std::vector<char> used(input_.points.size(), 0);
    markUsed(input_.polygons, used);
    markUsed(stripTriangles, used);
    markUsed(input_.lines, used);
    markUsed(input_.verts, used);
    weld(used);
    for (const CellList* faces : { &input_.polygons, &stripTriangles })
    {
      for (std::int64_t cell = 0; cell < faces->size(); ++cell)
      {
        addPolygon(corners(*faces, cell), faces->ids[cell]);
      }
    }
    for (std::int64_t cell = 0; cell < input_.lines.size(); ++cell)
    {
      addLine(corners(input_.lines, cell), input_.lines.ids[cell]);
    }
    for (std::int64_t cell = 0; cell < input_.verts.size(); ++cell)
    {
      for (const int point : corners(input_.verts, cell))
      {
        addVertex(point, input_.verts.ids[cell]);
      }
    }
    requireCells(mesh_);
    return std::move(mesh_);
  }

private:
  void checkSizes(const CellList& stripTriangles) const
  {
    requireConsistent(input_.polygons, "polygons");
    requireConsistent(input_.lines, "lines");
    requireConsistent(input_.verts, "verts");
    const std::size_t total = input_.polygons.connectivity.size() +
      stripTriangles.connectivity.size() + input_.lines.connectivity.size() +
      input_.verts.connectivity.size();
    requireCount("the mesh", static_cast<std::int64_t>(total), "cell corners", kMaxCorners);
  }

  void markUsed(const CellList& cells, std::vector<char>& used) const
  {
    const auto count = static_cast<std::int64_t>(used.size());
    for (std::int64_t cell = 0; cell < cells.size(); ++cell)
    {
      for (std::int64_t i = cells.offsets[cell]; i < cells.offsets[cell + 1]; ++i)
      {
        const std::int64_t point = cells.connectivity[i];
        if (point < 0 || point >= count)
        {
          throwBadPoint(cells.ids[cell], point, used.size());
        }
        used[point] = 1;
      }
    }
  }

  void weld(const std::vector<char>& used)
  {
    const std::size_t expected = std::count(used.begin(), used.end(), 1);
    PointWelder welder(expected);
    mesh_.pointOfInput.assign(used.size(), -1);
    for (std::size_t i = 0; i < used.size(); ++i)
    {
      if (!used[i])
      {
        continue;
      }
      const Point3& point = input_.points[i];
      requireUsable(i, point);
      mesh_.pointOfInput[i] = welder.insert(point, mesh_.points);
    }
    mesh_.weldedPoints = static_cast<std::int64_t>(expected - mesh_.points.size());
    const double diagonal = mesh_.bounds().diagonal();
    if (mesh_.points.size() > 1 && diagonal < kMinDiagonal)
    {
      std::ostringstream message;
      message << "the bounds of the points have a diagonal of " << diagonal << ", less than "
              << kMinDiagonal;
      throw Error(ErrorCode::InvalidInput, message.str());
    }
  }

  /// Welded points of a cell; valid until the next call.
  const std::vector<int>& corners(const CellList& cells, std::int64_t cell)
  {
    corners_.clear();
    for (std::int64_t i = cells.offsets[cell]; i < cells.offsets[cell + 1]; ++i)
    {
      corners_.push_back(mesh_.pointOfInput[cells.connectivity[i]]);
    }
    return corners_;
  }

  void addPolygon(const std::vector<int>& points, std::int64_t cell)
  {
    polygon_ = points;
    polygon_.erase(std::unique(polygon_.begin(), polygon_.end()), polygon_.end());
    while (polygon_.size() > 1 && polygon_.front() == polygon_.back())
    {
      polygon_.pop_back();
    }
    if (polygon_.size() < 3)
    {
      addLine(polygon_, cell);
    }
    else if (polygon_.size() == 3)
    {
      addTriangle({ polygon_[0], polygon_[1], polygon_[2] }, cell);
    }
    else
    {
      addTriangulated(cell);
    }
    // With neighbouring corners at the same place, there would have been triangles without area.
    mesh_.degenerateTriangles += static_cast<std::int64_t>(
      std::max<std::size_t>(points.size(), 2) - std::max<std::size_t>(polygon_.size(), 2));
  }

  void addTriangulated(std::int64_t cell)
  {
    positions_.clear();
    for (const int point : polygon_)
    {
      positions_.push_back(mesh_.points[point]);
    }
    for (const auto& t : triangulatePolygon(positions_, effort_))
    {
      addTriangle({ polygon_[t[0]], polygon_[t[1]], polygon_[t[2]] }, cell);
    }
  }

  void addTriangle(const std::array<int, 3>& t, std::int64_t cell)
  {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      // All three are one point only if the first two are and the last two are.
      addSegment(t[0], t[0] == t[1] ? t[2] : t[1], cell);
      ++mesh_.degenerateTriangles;
      return;
    }
    mesh_.triangles.push_back(t);
    mesh_.triangleCells.push_back(cell);
    if (!hasArea(mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]))
    {
      ++mesh_.degenerateTriangles;
    }
  }

  void addLine(const std::vector<int>& points, std::int64_t cell)
  {
    if (points.size() == 1)
    {
      addVertex(points[0], cell);
    }
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      addSegment(points[i - 1], points[i], cell);
    }
  }

  void addSegment(int a, int b, std::int64_t cell)
  {
    if (a == b)
    {
      addVertex(a, cell);
      return;
    }
    mesh_.segments.push_back({ a, b });
    mesh_.segmentCells.push_back(cell);
  }

  void addVertex(int point, std::int64_t cell)
  {
    mesh_.vertices.push_back(point);
    mesh_.vertexCells.push_back(cell);
  }

  const MeshInput& input_;
  TriangleMesh mesh_;
  // Kept between cells to save allocations.
  std::vector<int> corners_;
  std::vector<int> polygon_;
  std::vector<Point3> positions_;
  TriangulationEffort effort_;
};

} // namespace

void CellList::append(const std::vector<std::int64_t>& pointIds, std::int64_t cellId)
{
  connectivity.insert(connectivity.end(), pointIds.begin(), pointIds.end());
  offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  ids.push_back(cellId);
}

Bounds TriangleMesh::bounds() const
{
  return points.empty() ? Bounds() : boundsOf(points);
}

void requireUsable(std::size_t index, const Point3& point)
{
  const bool usable = std::all_of(point.begin(), point.end(),
    [](double coordinate) { return std::abs(coordinate) <= kMaxCoordinate; });
  if (!usable)
  {
    throwUnusable(index, point);
  }
}

bool hasArea(const Point3& a, const Point3& b, const Point3& c)
{
  const glm::dvec3 origin = toVector(a);
  glm::dvec3 u = toVector(b) - origin;
  glm::dvec3 v = toVector(c) - origin;
  const double longest = std::max({ glm::length(u), glm::length(v), glm::length(v - u) });
  if (longest == 0.0)
  {
    return false;
  }
  u /= longest;
  v /= longest;
  return glm::length(glm::cross(u, v)) > kMinRelativeHeight;
}

TriangleMesh buildTriangleMesh(const MeshInput& input)
{
  return MeshBuilder(input).build();
}

} // namespace medial

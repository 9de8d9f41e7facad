#pragma once

#include "medial/export.h"
#include "medial/grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Cells as lists of point ids: cell c uses connectivity[offsets[c]] to
/// connectivity[offsets[c+1]-1].
struct MEDIAL_EXPORT CellList
{
  std::vector<std::int64_t> offsets{ 0 }; ///< one more than cells, ascending
  std::vector<std::int64_t> connectivity; ///< point ids of all cells, one after the other
  /// The caller's id of every cell; reported back as ClosestCell.
  std::vector<std::int64_t> ids;

  /// Number of cells.
  std::int64_t size() const { return static_cast<std::int64_t>(ids.size()); }
  /// Adds a cell.
  void append(const std::vector<std::int64_t>& pointIds, std::int64_t cellId);
};

/// A polygon soup as a file or a VTK pipeline delivers it; nothing about it is assumed.
struct MeshInput
{
  std::vector<Point3> points; ///< world coordinates
  CellList polygons;          ///< triangles, quads and simple polygons, possibly concave
  CellList lines;             ///< polylines, two or more points each
  CellList verts;             ///< poly-vertices, one or more points each
  CellList strips;            ///< triangle strips; those of fewer than three points are left out
};

/// Triangles, segments and isolated points over welded points: the sites' geometry.
///
/// Bit-equal input points are one point here (-0 equals 0), and points that no cell uses are left
/// out. A triangle with only two distinct corners is kept as a segment, with one as a point.
/// Triangles with three distinct but collinear corners stay in `triangles`, so that the
/// connectivity has no hole; they have no face site, only their edges and vertices.
struct MEDIAL_EXPORT TriangleMesh
{
  std::vector<Point3> points;                ///< world coordinates
  std::vector<std::array<int, 3>> triangles; ///< ids of points
  std::vector<std::array<int, 2>> segments;  ///< not the edges of triangles, but line cells
  std::vector<int> vertices;                 ///< points that are cells of their own

  std::vector<std::int64_t> triangleCells; ///< input cell of every triangle
  std::vector<std::int64_t> segmentCells;  ///< input cell of every segment
  std::vector<std::int64_t> vertexCells;   ///< input cell of every vertex

  /// Welded point of every input point, -1 where no cell uses it.
  std::vector<int> pointOfInput;

  std::int64_t weldedPoints = 0;        ///< input points merged into an equal one
  std::int64_t degenerateTriangles = 0; ///< triangles without area, in whatever form they are kept

  /// Whether there is nothing in it.
  bool empty() const { return triangles.empty() && segments.empty() && vertices.empty(); }
  Bounds bounds() const; ///< of `points`; zero where there are none
};

/// What coordinates may be at most, in magnitude: squares of distances must fit single precision.
constexpr double kMaxCoordinate = 1e18;
/// Least diagonal of the bounds of points that are not all equal, world units.
constexpr double kMinDiagonal = 1e-18;

/// @throws Error InvalidInput, naming point `index`, for a coordinate that is not finite or beyond
///   kMaxCoordinate.
MEDIAL_EXPORT void requireUsable(std::size_t index, const Point3& point);

/// False when the height of triangle abc over its longest side is nil or lost in rounding, so that
/// it has no usable normal and counts as degenerate.
MEDIAL_EXPORT bool hasArea(const Point3& a, const Point3& b, const Point3& c);

/// Welds, triangulates and sorts out degenerate cells. Strips become triangles, polylines segments,
/// and pieces of them without length become points. A cell given twice is kept twice.
/// @throws Error InvalidInput for a coordinate of a point that a cell uses that is NaN or beyond
///   kMaxCoordinate (naming the input point), points that differ by less than
///   kMinDiagonal, a point id outside the list of points (naming cell and id), or an input
///   without any cell.
MEDIAL_EXPORT TriangleMesh buildTriangleMesh(const MeshInput& input);

} // namespace medial

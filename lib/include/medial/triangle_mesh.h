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
  std::vector<std::int64_t> offsets{ 0 }; ///< ascending, one more than cells
  std::vector<std::int64_t> connectivity; ///< point ids of all cells, one after the other
  /// The caller's id of every cell; the field returns it as ClosestCell.
  std::vector<std::int64_t> ids;

  /// Number of cells.
  std::int64_t size() const { return static_cast<std::int64_t>(ids.size()); }
  /// Adds a cell.
  /// @param pointIds in order along or around the cell.
  /// @param cellId the caller's id.
  void append(const std::vector<std::int64_t>& pointIds, std::int64_t cellId);
};

/// A polygon soup as a file or a VTK pipeline delivers it, without any guarantee.
struct MeshInput
{
  std::vector<Point3> points; ///< world coordinates
  CellList polygons;          ///< triangles, quads and simple polygons, possibly concave
  CellList lines;             ///< polylines, two or more points each
  CellList verts;             ///< poly-vertices, one or more points each
  CellList strips;            ///< triangle strips; those with fewer than three points are ignored

  /// Whether it has any cell.
  bool hasCells() const
  {
    return polygons.size() + lines.size() + verts.size() + strips.size() > 0;
  }
};

/// Triangles, segments and isolated points over welded points: the geometry of the sites.
///
/// Input points with bit-equal coordinates are one point here (-0 equals 0). Points that no cell
/// uses are left out. A triangle with only two distinct corners becomes a segment, and with only
/// one a point. Triangles with three distinct but collinear corners stay in `triangles`, so that
/// the connectivity has no hole. They have no face site, only sites for their edges and vertices.
struct MEDIAL_EXPORT TriangleMesh
{
  std::vector<Point3> points;                ///< world coordinates
  std::vector<std::array<int, 3>> triangles; ///< ids of points
  std::vector<std::array<int, 2>> segments;  ///< line cells, not the edges of triangles
  std::vector<int> vertices;                 ///< points that are cells of their own

  std::vector<std::int64_t> triangleCells; ///< input cell of every triangle
  std::vector<std::int64_t> segmentCells;  ///< input cell of every segment
  std::vector<std::int64_t> vertexCells;   ///< input cell of every vertex

  /// Welded point of every input point, -1 where no cell uses it.
  std::vector<int> pointOfInput;

  std::int64_t weldedPoints = 0;        ///< input points merged into an equal one
  std::int64_t degenerateTriangles = 0; ///< triangles without area, however they are kept

  /// Whether it has no cells.
  bool empty() const { return triangles.empty() && segments.empty() && vertices.empty(); }
  Bounds bounds() const; ///< bounds of `points`; zero if there are none
};

/// Largest magnitude of a coordinate: squares of distances must fit single precision.
constexpr double kMaxCoordinate = 1e18;
/// Smallest diagonal of the bounds of points that are not all equal, world units.
constexpr double kMinDiagonal = 1e-18;

/// Checks the coordinates of a point.
/// @throws Error InvalidInput, naming point `index`, for a coordinate that is not finite or beyond
///   kMaxCoordinate.
MEDIAL_EXPORT void requireUsable(std::size_t index, const Point3& point);

/// Whether triangle abc has an area. False if its height over the longest side is zero or lost in
/// rounding: it then has no usable normal and counts as degenerate.
MEDIAL_EXPORT bool hasArea(const Point3& a, const Point3& b, const Point3& c);

/// Makes a mesh of a polygon soup: welds points, splits polygons into triangles, and sorts out
/// degenerate cells. Strips become triangles and polylines become segments; their pieces without
/// length become points. A cell given twice is kept twice.
/// @throws Error InvalidInput for a used point with a coordinate that is not finite or beyond
///   kMaxCoordinate (naming the input point), points that differ by less than kMinDiagonal, a point
///   id outside the list of points (naming cell and id), or an input without cells.
MEDIAL_EXPORT TriangleMesh buildTriangleMesh(const MeshInput& input);

} // namespace medial

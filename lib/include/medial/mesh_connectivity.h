#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Lists of variable length in one array: row r is values[offsets[r]] .. values[offsets[r+1]-1].
struct IncidenceLists
{
  std::vector<int> offsets{ 0 }; ///< one more than rows, ascending
  std::vector<int> values;       ///< of all rows, one after the other

  /// Number of rows.
  int rows() const { return static_cast<int>(offsets.size()) - 1; }
  /// Length of a row.
  int size(int row) const { return offsets[row + 1] - offsets[row]; }
  /// First value of a row.
  const int* begin(int row) const { return values.data() + offsets[row]; }
  /// Past the last value of a row.
  const int* end(int row) const { return values.data() + offsets[row + 1]; }
};

/// How the cells and points of a TriangleMesh, manifold or not, are connected, and the properties
/// of the whole mesh that follow.
struct MEDIAL_EXPORT MeshConnectivity
{
  /// Undirected edges as pairs of points: those of the triangles, then the segments that are not
  /// edges of a triangle.
  std::vector<std::array<int, 2>> edges;
  /// Edge i of a triangle joins its corners i and (i+1)%3.
  std::vector<std::array<int, 3>> triangleEdges;
  std::vector<int> segmentEdges; ///< per segment: its edge, which can also belong to a triangle
  IncidenceLists edgeTriangles;  ///< per edge: its triangles, 0, 1, 2, 3 or more
  IncidenceLists pointEdges;     ///< per point: the edges that end there

  std::vector<std::int64_t> edgeCells;  ///< per edge: an input cell that contains it
  std::vector<std::int64_t> pointCells; ///< per point: an input cell that contains it

  int components = 0;       ///< pieces connected through points
  int boundaryEdges = 0;    ///< edges with one triangle
  int nonManifoldEdges = 0; ///< edges with three or more triangles
  int misorientedEdges = 0; ///< edges that both their triangles run through in the same direction
  /// Triangles that an oriented manifold half-edge mesh refuses when they are added in their order.
  int nonManifoldTriangles = 0;
  /// Points where that half-edge mesh has more than one gap, as in open bow-ties.
  int nonManifoldPoints = 0;
  /// World units cubed; negative if the faces of a closed mesh point inwards, meaningless for an
  /// open mesh.
  double signedVolume = 0.0;

  bool closed() const; ///< whether there are only triangles, and two at every edge
  /// Whether no triangle and no point is non-manifold.
  bool manifold() const;
  /// Whether no edge is misoriented.
  bool oriented() const { return misorientedEdges == 0; }
};

/// Analyses the connectivity of a mesh. Edges have their ids in the order in which triangles name
/// them, then come the segments'. The numbering depends only on the order of the mesh's lists. The
/// time is n log n in the size of the mesh, however many triangles meet at a point.
/// @param execution its progress stays at 0 throughout, so that the next step can begin there; one
///   thread is used.
/// @throws Error InvalidInput for a point id that is out of range or repeated within a triangle or
///   segment, for lists of cell ids of the wrong size, and for more than 2147483647 sides, ends of
///   edges or sites; meshes from buildTriangleMesh() have none of these. Error Cancelled.
MEDIAL_EXPORT MeshConnectivity analyseConnectivity(const TriangleMesh& mesh,
  const Execution& execution = {});

/// Returns the volume that the triangles enclose by their orientation, world units cubed; see
/// MeshConnectivity::signedVolume.
MEDIAL_EXPORT double signedVolume(const TriangleMesh& mesh);

} // namespace medial

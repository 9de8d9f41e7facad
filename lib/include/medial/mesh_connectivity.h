#pragma once

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

/// Who touches whom in a TriangleMesh, manifold or not, and what follows for the whole mesh.
struct MEDIAL_EXPORT MeshConnectivity
{
  /// Undirected edges as point pairs: those of the triangles, then the segments that are no edge of
  /// a triangle.
  std::vector<std::array<int, 2>> edges;
  /// Edge i of a triangle joins its corners i and (i+1)%3.
  std::vector<std::array<int, 3>> triangleEdges;
  std::vector<int> segmentEdges; ///< per segment: its edge, which a triangle may have too
  IncidenceLists edgeTriangles;  ///< per edge: its triangles, 0, 1, 2, 3 or more
  IncidenceLists pointEdges;     ///< per point: the edges that end there

  std::vector<std::int64_t> edgeCells;  ///< per edge: an input cell that holds it
  std::vector<std::int64_t> pointCells; ///< per point: an input cell that holds it

  int components = 0;       ///< pieces connected through points
  int boundaryEdges = 0;    ///< edges with one triangle
  int nonManifoldEdges = 0; ///< edges with three or more triangles
  int misorientedEdges = 0; ///< edges whose two triangles run through them the same way
  /// Triangles that an oriented manifold half-edge mesh cannot hold, added in their order.
  int nonManifoldTriangles = 0;
  /// Points at which that half-edge mesh has more than one gap, as open bow-ties.
  int nonManifoldPoints = 0;
  /// World units cubed; negative when closed faces point inwards, of no meaning for open meshes.
  double signedVolume = 0.0;

  bool closed() const; ///< triangles only, every edge has two of them
  /// No triangle or point was refused.
  bool manifold() const;
  /// No edge is misoriented.
  bool oriented() const { return misorientedEdges == 0; }
};

/// Connectivity of the manifold part from OpenMesh; triangles that it refuses join by their edges.
/// The numbering depends on the order of the mesh's lists only. The time is linear in the size of
/// the mesh, but may be quadratic in the number of triangles around one point.
/// @throws Error InvalidInput for a point id that is out of range or repeated within a triangle or
///   segment, and for lists of cell ids of the wrong size; buildTriangleMesh makes none of these.
MEDIAL_EXPORT MeshConnectivity analyseConnectivity(const TriangleMesh& mesh);

/// Volume that the triangles enclose by their orientation, world units cubed; as in
/// MeshConnectivity.
MEDIAL_EXPORT double signedVolume(const TriangleMesh& mesh);

} // namespace medial

#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "sign/rim.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace medial
{

/// How each triangle of a surface counts for the solid that the surface stands for.
struct SurfaceOrientation
{
  /// Per triangle: 1 as it is, -1 turned round, 0 for the copy of an earlier triangle.
  std::vector<std::int8_t> weights;
  /// Per triangle: 1 as it is, -1 turned round; copies face the way of the triangle that counts.
  std::vector<std::int8_t> directions;
  std::vector<RimEdge> rim; ///< empty if the surface is closed
  std::int64_t copies = 0;  ///< triangles with the corners of an earlier one
  std::int64_t turned = 0;  ///< triangles turned round
};

/// Decides how the triangles of a mesh count. Patches are the pieces that are connected through
/// edges of two triangles. Inside a patch all triangles get the direction of most of its area. Then
/// patches that enclose a solid, up to small holes, are turned:
/// - outwards, if no other of them contains them,
/// - together with the smallest one that contains them, otherwise: a patch that faces the other way
///   than its container is a cavity.
SurfaceOrientation orientSurface(const TriangleMesh& mesh, const MeshConnectivity& connectivity);

/// Does the work of orientSurface() for one mesh whose points move. What follows from the
/// connectivity alone is found once, and so is the result where no patch turns.
class SurfaceOrienter
{
public:
  SurfaceOrienter();
  ~SurfaceOrienter();
  SurfaceOrienter(const SurfaceOrienter&) = delete;
  SurfaceOrienter& operator=(const SurfaceOrienter&) = delete;

  /// Returns what orientSurface() returns; valid until the next call.
  /// @param mesh, connectivity those of the first call, but for positions.
  const SurfaceOrientation& orient(const TriangleMesh& mesh, const MeshConnectivity& connectivity);

private:
  class Surface;
  std::unique_ptr<Surface> surface_; ///< null before the first call
};

/// A mesh whose triangles face the way they count.
struct OrientedMesh
{
  TriangleMesh mesh;
  MeshConnectivity connectivity; ///< its counts and volume are those of the mesh as it was
};

/// Turns triangles round; returns nothing if there is nothing to turn. Ids of triangles, edges and
/// points stay the same.
std::optional<OrientedMesh> turned(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const SurfaceOrientation& orientation);

} // namespace medial

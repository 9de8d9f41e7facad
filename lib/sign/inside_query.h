#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "sign/winding_number.h"
#include "sites/local_coordinates.h"

#include <glm/glm.hpp>

namespace medial
{

/// Tells whether points anywhere are inside a mesh. Unlike InsideRows it needs no grid. Several
/// threads may query it at once.
class InsideQuery
{
public:
  /// @param local coordinates of the points.
  InsideQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const LocalCoordinates& local);

  /// Whether the surface has triangles and no holes.
  bool closed() const { return closed_; }
  /// Whether the winding number is above 1/2 at a point, local coordinates.
  bool contains(const glm::dvec3& x) const { return winding_.isAboveHalf(x); }

private:
  InsideQuery(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
    const LocalCoordinates& local);

  WindingNumber winding_;
  bool closed_;
};

} // namespace medial

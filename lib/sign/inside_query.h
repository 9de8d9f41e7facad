#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "sign/line_winding.h"
#include "sign/surface_orientation.h"
#include "sign/winding_number.h"
#include "sites/local_coordinates.h"

#include <glm/glm.hpp>

#include <memory>

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
  bool closed() const { return closed_ != nullptr; }
  /// Whether the winding number is above 1/2 at a point, local coordinates.
  bool contains(const glm::dvec3& x) const
  {
    return closed_ ? closed_->at(x) > 0 : open_->isAboveHalf(x);
  }

private:
  // One of them.
  std::unique_ptr<const LineWinding> closed_;
  std::unique_ptr<const WindingNumber> open_;
};

} // namespace medial

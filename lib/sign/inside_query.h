#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"
#include "sign/line_winding.h"
#include "sign/sign_decision.h"
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
  explicit InsideQuery(ClosedSurface surface);
  /// @param local coordinates of the points.
  InsideQuery(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const LocalCoordinates& local);

  /// Whether the surface has triangles and no holes.
  bool closed() const { return hasTriangles_ && lids_ == nullptr; }
  /// Whether the winding number is above 1/2 at a point, local coordinates.
  bool contains(const glm::dvec3& x) const;

private:
  bool hasTriangles_;
  std::unique_ptr<const LineWinding> surface_; ///< with its lids
  std::unique_ptr<const WindingNumber> lids_;  ///< null if there are none
};

/// Whether the winding number of a surface is above 1/2.
/// @param closed returns that of the surface with its lids, which is an integer.
/// @param lids null if there are none.
template <typename Closed>
bool isInside(const Closed& closed, const WindingNumber* lids, const glm::dvec3& x)
{
  if (lids == nullptr)
  {
    return closed(x) > 0;
  }
  // Off the lids, where one of the numbers would jump before the other.
  const glm::dvec3 beside = x + kBeside;
  return lids->isBelow(closed(beside) - 0.5, beside);
}

} // namespace medial

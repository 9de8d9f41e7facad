#pragma once

#include "base/checkpoint.h"
#include "medial/mesh_connectivity.h"
#include "medial/sign_method.h"
#include "medial/triangle_mesh.h"
#include "sign/inside_query.h"
#include "sites/closest_point.h"
#include "sites/local_coordinates.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace medial
{

/// Tells whether points anywhere are inside a mesh, by the rules of a field's sign.
class PointSide
{
public:
  /// @param sites of the mesh, must outlive this; in the local coordinates of the points.
  /// @throws Error InvalidInput if the mesh does not allow the method; Cancelled.
  PointSide(SignMethod requested, const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const LocalCoordinates& local, const SiteSet& sites, const Checkpoint& checkpoint);

  const SignReport& report() const { return report_; }

  /// Whether all points of a ball that the surface does not reach into are on one side. Where the
  /// surface has holes, they need not be.
  bool changesOnlyAtSurface() const { return !inside_ || inside_->closed(); }

  /// A point and what is known of it.
  struct Known
  {
    glm::dvec3 x{ 0.0 };
    double distance = 0.0; ///< from the surface; 0 if nothing is known
    bool inside = false;
  };

  /// Whether a point is inside; false if the mesh has no inside.
  /// @param closest its closest point.
  /// @param known some point near it. Becomes this point if it was of no help. The answer does not
  ///   depend on it.
  bool contains(const glm::dvec3& x, const SitePoint& closest, Known& known) const;

private:
  bool behindPseudonormal(const glm::dvec3& x, const SitePoint& closest) const;

  SignReport report_;
  std::vector<glm::vec4> normals_; ///< of all sites, outwards; empty unless they give the sign
  glm::dvec3 low_{ 0.0 };          ///< bounds of the mesh, if they do; local coordinates
  glm::dvec3 high_{ 0.0 };
  std::optional<InsideQuery> inside_;
};

} // namespace medial

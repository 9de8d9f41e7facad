#include "query/point_side.h"

#include "sign/sign_choice.h"
#include "sites/grid_frame.h"
#include "sites/pseudonormals.h"

namespace medial
{
namespace
{

/// The rules of SignMethod::Auto look at a grid: at this many points along its longest axis, as
/// for a field of any resolution.
constexpr int kRuleResolution = 256;

SignReport choose(SignMethod requested, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Checkpoint& checkpoint)
{
  const Grid grid = makeGrid(mesh.bounds(), kRuleResolution);
  SurfaceOrienter orienter;
  return SignChoice(requested, mesh, connectivity, grid, GridFrame(grid), orienter, checkpoint)
    .report();
}

} // namespace

PointSide::PointSide(SignMethod requested, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const LocalCoordinates& local, const SiteSet& sites,
  const Checkpoint& checkpoint)
  : report_(choose(requested, mesh, connectivity, checkpoint))
{
  if (report_.method == SignMethod::Pseudonormal)
  {
    normals_ = pseudonormals(sites, connectivity.signedVolume < 0.0);
    const Bounds bounds = mesh.bounds();
    low_ = local.toLocal(bounds.min);
    high_ = local.toLocal(bounds.max);
  }
  if (report_.method == SignMethod::Winding)
  {
    inside_.emplace(mesh, connectivity, local);
  }
}

bool PointSide::contains(const glm::dvec3& x, const SitePoint& closest, Known& known) const
{
  if (!inside_)
  {
    return !normals_.empty() && this->behindPseudonormal(x, closest);
  }
  if (!this->changesOnlyAtSurface())
  {
    return inside_->contains(x);
  }
  // No surface is between two points if one is in the ball of the other up to the surface, so both
  // have the same winding number. This leaves room for rounding.
  constexpr double kWellWithin = 1.0 - 1e-6;
  if (glm::distance(x, known.x) >= kWellWithin * known.distance)
  {
    known = { x, glm::distance(x, closest.point), inside_->contains(x) };
  }
  return known.inside;
}

// Only a closed mesh has pseudonormals, so whatever is beyond its bounds is outside. They would not
// tell: from far away, sites that face the point and sites that look away are equally near, up to
// rounding.
bool PointSide::behindPseudonormal(const glm::dvec3& x, const SitePoint& closest) const
{
  if (glm::any(glm::lessThan(x, low_)) || glm::any(glm::greaterThan(x, high_)))
  {
    return false;
  }
  return glm::dot(x - closest.point, glm::dvec3(normals_[closest.site])) < 0.0;
}

} // namespace medial

#include "query/distance_query.h"

#include "base/checkpoint.h"
#include "medial/error.h"
#include "mesh/cell_check.h"

#include <utility>

namespace medial
{
namespace
{

/// Of LocalCoordinates::around().
constexpr double kMargin = 0.05;

} // namespace

LocalCoordinates DistanceQuery::localOf(const TriangleMesh& mesh)
{
  requireCells(mesh);
  return LocalCoordinates::around(mesh.bounds(), kMargin);
}

DistanceQuery::DistanceQuery(TriangleMesh mesh, SignMethod sign, const Run& run,
  const Execution& execution)
  : mesh_(std::move(mesh))
  , local_(localOf(mesh_))
  , connectivity_(analyseConnectivity(mesh_, execution))
  , sites_(mesh_, connectivity_, local_)
  , tree_(sites_, connectivity_, roundingNear(0.0, sites_))
  , query_(tree_)
  , cells_(mesh_, connectivity_)
  , side_(sign, mesh_, connectivity_, local_, sites_, Checkpoint(run, 0.0, "distances"))
{
}

const SitePoint& DistanceQuery::Search::closest(const glm::dvec3& x)
{
  const SitePoint start =
    closest_.site >= 0 ? closestPoint(query_.sites_, closest_.site, x) : SitePoint{};
  closest_ = query_.query_.closest(x, start);
  return closest_;
}

} // namespace medial

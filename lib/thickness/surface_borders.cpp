#include "thickness/surface_borders.h"

#include <utility>

namespace medial
{
namespace
{

/// Cosine of the angle up to which a face is turned to where it is seen from.
constexpr double kTurned = 0.866;

} // namespace

SurfaceBorders::SurfaceBorders(const SiteSet& sites, const MeshConnectivity& connectivity,
  double diagonal, double sign, const std::vector<char>& complete)
  : tolerance_(toleranceOf(diagonal))
{
  std::vector<glm::dvec3> points;
  const IncidenceLists& faces = connectivity.edgeTriangles;
  for (int edge = 0; edge < static_cast<int>(sites.edges().size()); ++edge)
  {
    const glm::ivec2& corners = sites.edges()[edge];
    const bool isKnown = complete.empty() || complete[corners[0]] != 0 || complete[corners[1]] != 0;
    if (!isKnown || faces.end(edge) - faces.begin(edge) != 1)
    {
      continue;
    }
    points.push_back(sites.points()[corners[0]]);
    points.push_back(sites.points()[corners[1]]);
    inward_.push_back(-sign * sites.faceNormal(*faces.begin(edge)));
  }
  segments_.build(std::move(points));
}

bool SurfaceBorders::isSeam(const glm::dvec3& place, const glm::dvec3& direction) const
{
  return segments_.isNear(place, tolerance_,
    [&](int edge) { return glm::dot(inward_[edge], direction) < kTurned; });
}

} // namespace medial

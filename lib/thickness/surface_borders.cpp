#include "thickness/surface_borders.h"

#include "base/segment_distance.h"

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
  std::vector<glm::ivec3> ends;
  const IncidenceLists& faces = connectivity.edgeTriangles;
  for (int edge = 0; edge < static_cast<int>(sites.edges().size()); ++edge)
  {
    const glm::ivec2& corners = sites.edges()[edge];
    const bool isKnown = complete.empty() || complete[corners[0]] != 0 || complete[corners[1]] != 0;
    if (!isKnown || faces.end(edge) - faces.begin(edge) != 1)
    {
      continue;
    }
    const auto first = static_cast<int>(points_.size());
    points_.push_back(sites.points()[corners[0]]);
    points_.push_back(sites.points()[corners[1]]);
    inward_.push_back(-sign * sites.faceNormal(*faces.begin(edge)));
    ends.emplace_back(first, first + 1, first + 1);
  }
  if (!ends.empty())
  {
    tree_.build(points_, ends);
  }
}

bool SurfaceBorders::isSeam(const glm::dvec3& place, const glm::dvec3& direction) const
{
  if (points_.empty())
  {
    return false;
  }
  const double limit = tolerance_ * tolerance_;
  bool found = false;
  tree_.visitLeaves([&](const Box& box)
    { return !found && box.squaredDistance(place) <= limit * Box::kRoundedUp; },
    [&](const BoxTree::Node& leaf)
    {
      for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
      {
        const int edge = tree_.elements()[slot];
        found = found ||
          (glm::dot(inward_[edge], direction) < kTurned &&
            squaredDistanceToSegment(place, points_[2 * edge], points_[2 * edge + 1]) <= limit);
      }
    });
  return found;
}

} // namespace medial

#include "culling/site_query.h"

#include "culling/block_query.h"
#include "culling/nearest_element.h"
#include "culling/nearest_site.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Squares of coordinates farther out do not fit single precision.
constexpr double kMaxReach = 1e18;

/// Returns the squared distance in single precision within which discs may hold nearer elements.
float limitAt(double distance, float slack)
{
  const float reach = static_cast<float>(distance) + 2.0f * slack;
  return std::min(reach * reach * kRoundedUp, std::numeric_limits<float>::max());
}

/// Returns a distance in single precision, rounded up.
float roundedUp(double distance)
{
  return static_cast<float>(distance) * (1.0f + std::numeric_limits<float>::epsilon());
}

} // namespace

SiteQuery::SiteQuery(const GroupTree& tree)
  : tree_(tree)
{
}

SitePoint SiteQuery::search(const glm::dvec3& x, double bound, double limit) const
{
  if (!inReach(x))
  {
    return this->searchFromAfar(x, limit);
  }
  NearestSite nearest(tree_.sites(), x, limit);
  const auto reach = [&] { return std::min(bound, nearest.distance()); };
  SiteGroup::IntLanes parts;
  const glm::vec3 rounded(x);
  tree_.visitNear(
    rounded, [&] { return limitAt(reach(), tree_.slack()); },
    [&](int id)
    {
      const SiteGroup& group = tree_.groups()[id];
      const unsigned lanes =
        NearestSite::sitesNear(group, group.toGroup(x), roundedUp(reach()), tree_.slack(), parts);
      nearest.offer(group, lanes, parts);
    });
  return nearest.closest();
}

SitePoint SiteQuery::searchFromAfar(const glm::dvec3& x, double limit) const
{
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  const double length = glm::length(x);
  if (!(length < kAnywhere))
  {
    return {};
  }
  // Which point is nearest depends on the direction alone: what the distance changes is far below
  // the rounding of the distances.
  const SitePoint found = this->search(x * (0.5 * kMaxReach / length), kAnywhere, kAnywhere);
  return glm::distance(found.point, x) < limit ? found : SitePoint{};
}

bool SiteQuery::inReach(const glm::dvec3& x)
{
  return glm::length(x) <= kMaxReach;
}

SitePoint SiteQuery::closest(const glm::dvec3& x, const SitePoint& known) const
{
  const SitePoint start = known.site >= 0
    ? known
    : closestPoint(tree_.sites(), tree_.groups().front().elements.front(), x);
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  const SitePoint found = this->search(x, glm::distance(x, start.point), kAnywhere);
  return found.site >= 0 ? found : start;
}

SitePoint SiteQuery::closestWithin(const glm::dvec3& x, double limit) const
{
  return this->search(x, limit, limit);
}

void SiteQuery::closest(std::vector<Question>& questions) const
{
  BlockQuery(*this, tree_).answer(questions);
}

} // namespace medial

#include "culling/site_query.h"

#include "culling/nearest_element.h"

#include <algorithm>

namespace medial
{
namespace
{

constexpr unsigned kAllLanes = (1u << SiteGroup::kSize) - 1u;

/// Returns the squared distance in single precision within which elements may be nearer.
float limitAt(double distance, float slack)
{
  const float reach = static_cast<float>(distance) + 2.0f * slack;
  return std::min(reach * reach * kRoundedUp, std::numeric_limits<float>::max());
}

/// Returns the elements of a group within a squared distance, as bits.
MEDIAL_VECTORISED unsigned elementsWithin(const SiteGroup& group, const glm::dvec3& x, float limit)
{
  return bits(ElementPosition(group, group.toGroup(x)).squared <= limit);
}

} // namespace

SiteQuery::SiteQuery(const GroupTree& tree)
  : tree_(tree)
{
}

SitePoint SiteQuery::search(const glm::dvec3& x, SitePoint closest, double distance) const
{
  const SiteSet& sites = tree_.sites();
  float limit = limitAt(distance, tree_.slack());
  const auto tryElements = [&](const SiteGroup& group, unsigned lanes)
  {
    for (unsigned left = lanes; left != 0; left &= left - 1)
    {
      const SitePoint candidate = closestPoint(sites, group.elements[__builtin_ctz(left)], x);
      const double found = glm::distance(candidate.point, x);
      if (found < distance || (found == distance && candidate.site < closest.site))
      {
        distance = found;
        closest = candidate;
        limit = limitAt(distance, tree_.slack());
      }
    }
  };
  // Squares of coordinates farther out do not fit single precision.
  constexpr double kMaxReach = 1e18;
  if (!(glm::length(x) <= kMaxReach))
  {
    for (const SiteGroup& group : tree_.groups())
    {
      tryElements(group, kAllLanes);
    }
    return closest;
  }
  tree_.visitNear(
    glm::vec3(x), [&] { return limit; },
    [&](int id)
    {
      const SiteGroup& group = tree_.groups()[id];
      tryElements(group, elementsWithin(group, x, limit));
    });
  return closest;
}

SitePoint SiteQuery::closest(const glm::dvec3& x, const SitePoint& known) const
{
  const SitePoint start = known.site >= 0
    ? known
    : closestPoint(tree_.sites(), tree_.groups().front().elements.front(), x);
  return this->search(x, start, glm::distance(x, start.point));
}

SitePoint SiteQuery::closestWithin(const glm::dvec3& x, double limit) const
{
  return this->search(x, {}, limit);
}

void SiteQuery::closest(std::vector<Question>& questions) const
{
  for (Question& question : questions)
  {
    question.closest = this->closest(question.x, question.closest);
  }
}

} // namespace medial

#include "culling/site_query.h"

#include "culling/nearest_element.h"

#include <algorithm>

namespace medial
{
namespace
{

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

SiteQuery::SiteQuery(const GroupTree& tree, float slack)
  : tree_(tree)
  , slack_(slack)
{
}

SitePoint SiteQuery::closest(const glm::dvec3& x, const SitePoint& known) const
{
  const SitePoint start = known.site >= 0
    ? known
    : closestPoint(tree_.sites(), tree_.groups().front().elements.front(), x);
  SitePoint closest = start;
  double distance = glm::distance(x, start.point);
  float limit = limitAt(distance, slack_);
  const auto tryElement = [&](int element)
  {
    const SitePoint candidate = closestPoint(tree_.sites(), element, x);
    const double found = glm::distance(candidate.point, x);
    if (found < distance)
    {
      distance = found;
      closest = candidate;
      limit = limitAt(distance, slack_);
    }
  };
  tree_.visitNear(
    glm::vec3(x), [&] { return limit; },
    [&](int id)
    {
      const SiteGroup& group = tree_.groups()[id];
      for (unsigned left = elementsWithin(group, x, limit); left != 0; left &= left - 1)
      {
        tryElement(group.elements[__builtin_ctz(left)]);
      }
    });
  return closest;
}

void SiteQuery::closest(std::vector<Question>& questions) const
{
  for (Question& question : questions)
  {
    question.closest = this->closest(question.x, question.closest);
  }
}

} // namespace medial

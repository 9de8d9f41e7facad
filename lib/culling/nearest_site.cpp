#include "culling/nearest_site.h"

#include <algorithm>
#include <cstring>

namespace medial
{

MEDIAL_VECTORISED unsigned NearestSite::sitesNear(const SiteGroup& group, const glm::vec3& x,
  float distance, float slack, SiteGroup::IntLanes& parts)
{
  const float rounding = roundingFrom(x, group.extent);
  const float reach = distance + rounding;
  const ElementPosition position(group, x);
  const Int8 near = position.squared <= std::min(reach * reach, std::numeric_limits<float>::max());
  if (bits(near) == 0)
  {
    return 0;
  }
  const Int8 found = partsNear(group, AllElements(), position, slack + rounding) & near;
  std::memcpy(parts.data(), &found, sizeof(found));
  return bits(found != 0);
}

NearestSite::NearestSite(const SiteSet& sites, const glm::dvec3& x, double limit)
  : sites_(sites)
  , x_(x)
  , distance_(limit)
{
}

NearestSite::NearestSite(const SiteSet& sites, const glm::dvec3& x, const SitePoint& known,
  int other)
  : sites_(sites)
  , x_(x)
  , closest_(known)
  , distance_(glm::distance(known.point, x))
  , known_(known.site)
  , other_(other)
{
}

void NearestSite::compare(int site)
{
  const SitePoint candidate = closestPoint(sites_, site, x_);
  const double found = glm::distance(candidate.point, x_);
  if (found < distance_ || (found == distance_ && candidate.site < closest_.site))
  {
    distance_ = found;
    closest_ = candidate;
  }
}

void NearestSite::offer(const SiteGroup& group, unsigned lanes, const SiteGroup::IntLanes& parts)
{
  for (; lanes != 0; lanes &= lanes - 1)
  {
    const int lane = __builtin_ctz(lanes);
    for (auto left = static_cast<unsigned>(parts[lane]); left != 0; left &= left - 1)
    {
      this->offer(siteOf(sites_, group, lane, __builtin_ctz(left)));
    }
  }
}

} // namespace medial

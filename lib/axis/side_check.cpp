#include "axis/side_check.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace medial
{

SideCheck::SideCheck(std::function<InsideQuery()> makeInside)
  : SideCheck(
      [make = std::move(makeInside)]() -> Inside
      {
        const auto query = std::make_shared<const InsideQuery>(make());
        return [query](const glm::dvec3& x) { return query->contains(x); };
      })
{
}

SideCheck::SideCheck(std::function<Inside()> makeInside)
  : makeInside_(std::move(makeInside))
{
}

bool SideCheck::isAcross(const glm::dvec3& known, double reach, const BisectorPoint& point) const
{
  return glm::distance(known, point.position) >= std::max(reach, point.radius()) &&
    this->inside()(known) != this->inside()(point.position);
}

const SideCheck::Inside& SideCheck::inside() const
{
  tbb::collaborative_call_once(once_, [this] { inside_ = makeInside_(); });
  return inside_;
}

} // namespace medial

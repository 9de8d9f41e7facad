#include "axis/side_check.h"

#include "sign/inside_query.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace medial
{

SideCheck::SideCheck(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const LocalCoordinates& local)
  : SideCheck(
      [&mesh, &connectivity, &local]() -> Inside
      {
        const auto query = std::make_shared<const InsideQuery>(mesh, connectivity, local);
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
  std::call_once(once_, [this] { inside_ = makeInside_(); });
  return inside_;
}

} // namespace medial

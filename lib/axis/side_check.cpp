#include "axis/side_check.h"

#include <algorithm>

namespace medial
{

SideCheck::SideCheck(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const LocalCoordinates& local)
  : mesh_(mesh)
  , connectivity_(connectivity)
  , local_(local)
{
}

bool SideCheck::isAcross(const glm::dvec3& known, double reach, const BisectorPoint& point) const
{
  return glm::distance(known, point.position) >= std::max(reach, point.radius()) &&
    this->inside().contains(known) != this->inside().contains(point.position);
}

const InsideQuery& SideCheck::inside() const
{
  std::call_once(once_,
    [this] { inside_ = std::make_unique<const InsideQuery>(mesh_, connectivity_, local_); });
  return *inside_;
}

} // namespace medial

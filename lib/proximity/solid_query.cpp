#include "proximity/solid_query.h"

#include "sign/closed_surface.h"
#include "sign/line_winding.h"

namespace medial
{

SolidQuery::OpenSolid::OpenSolid(const MovingMesh& mesh)
  : local(LocalCoordinates::around(mesh.mesh().bounds(), 0.0))
  , winding(chainOf(mesh.mesh(), mesh.orientation(), local))
{
}

void SolidQuery::update()
{
  const bool isOpen = !mesh_.closed() && !mesh_.mesh().triangles.empty();
  open_ = isOpen ? std::make_unique<OpenSolid>(mesh_) : nullptr;
}

Place SolidQuery::placeOf(const glm::dvec3& x) const
{
  if (mesh_.closed())
  {
    return mesh_.tree().box().contains(x) && this->windingNumber(x) > 0 ? Place::Inside
                                                                        : Place::Outside;
  }
  if (open_ == nullptr)
  {
    return Place::Outside;
  }
  constexpr double kLow = 0.25;
  constexpr double kHigh = 0.75;
  constexpr double kTolerance = 1e-3;
  const Interval value = open_->winding.bounds(open_->local.toLocal({ x.x, x.y, x.z }), kTolerance);
  const double middle = 0.5 * (value.low + value.high);
  return middle < kLow ? Place::Outside : (middle > kHigh ? Place::Inside : Place::Undefined);
}

int SolidQuery::windingNumber(const glm::dvec3& x) const
{
  int sum = 0;
  mesh_.tree().visitLeaves([&](const Box& box) { return meetsLineBefore(box, x); },
    [&](const BoxTree::Node& leaf) { sum += this->crossingsBefore(leaf, x); });
  return sum;
}

int SolidQuery::crossingsBefore(const BoxTree::Node& leaf, const glm::dvec3& x) const
{
  int sum = 0;
  for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
  {
    const int weight = mesh_.weight(slot);
    if (weight != 0 && meetsLineBefore(mesh_.boxOf(slot), x))
    {
      sum += weight * crossingBefore(mesh_.element(slot).corners, x);
    }
  }
  return sum;
}

} // namespace medial

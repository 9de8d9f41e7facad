#include "sign/lids.h"

#include <cmath>

namespace medial
{
namespace
{

/// Largest error of a lid that counts as one dipole.
constexpr double kFarTolerance = 1e-3;
/// Largest error of a group of triangles of a near lid.
constexpr double kNearTolerance = 1e-3;

int nearest(double value)
{
  return static_cast<int>(std::floor(value + 0.5));
}

} // namespace

Lids::Lids(const ClosedSurface& surface)
{
  for (std::size_t i = 0; i < surface.lidCount(); ++i)
  {
    TriangleChain lid = surface.lid(i);
    rims_.emplace_back(lid);
    windings_.emplace_back(std::move(lid));
  }
}

Lids::View Lids::everything() const
{
  View view;
  view.far.radius = HUGE_VAL;
  for (std::size_t i = 0; i < windings_.size(); ++i)
  {
    view.near.push_back(static_cast<int>(i));
  }
  return view;
}

Lids::View Lids::look(const View& outer, const glm::dvec3& centre, double radius) const
{
  View view;
  view.far = outer.far;
  view.far.value = outer.far.at(centre);
  view.far.centre = centre;
  view.far.radius = radius;
  for (const int lid : outer.near)
  {
    if (!windings_[lid].addDipole(kFarTolerance, view.far))
    {
      view.near.push_back(lid);
    }
  }
  return view;
}

Interval Lids::bounds(const View& view, const glm::dvec3& point, double tolerance) const
{
  const double far = view.far.at(point);
  Interval sum{ far - view.far.error, far + view.far.error };
  for (const int lid : view.near)
  {
    const Interval near = windings_[lid].bounds(point, tolerance);
    sum.low += near.low;
    sum.high += near.high;
  }
  return sum;
}

Interval Lids::smoothBounds(const View& view) const
{
  double change = view.far.change() - view.far.error;
  for (std::size_t i = 0; i < view.near.size() && change < 1.0; ++i)
  {
    change += view.far.radius * rims_[view.near[i]].maxGradient(view.far.centre, view.far.radius);
  }
  // Not worth a look.
  if (change >= 0.5)
  {
    return { -HUGE_VAL, HUGE_VAL };
  }
  const Interval middle = this->bounds(view, view.far.centre, kNearTolerance);
  return { middle.low - change, middle.high + change };
}

bool Lids::mayMeet(const View& view) const
{
  for (const int lid : view.near)
  {
    if (windings_[lid].mayMeet(view.far.centre, view.far.radius))
    {
      return true;
    }
  }
  return false;
}

double Lids::roughly(const View& view, const glm::dvec3& point) const
{
  constexpr double kRough = 1e-2;
  const Interval value = this->bounds(view, point, kRough);
  return value.high - value.low <= 0.2 ? 0.5 * (value.low + value.high) : this->at(point, 0.1);
}

double Lids::at(const glm::dvec3& point, double precision) const
{
  double sum = 0.0;
  for (const WindingNumber& winding : windings_)
  {
    sum += winding.at(point, precision / static_cast<double>(windings_.size()));
  }
  return sum;
}

int Lids::rounded(const View& view, const glm::dvec3& point) const
{
  for (const View& from : { view, this->everything() })
  {
    for (const double tolerance : { 1e-3, 1e-4, 1e-5 })
    {
      const Interval value = this->bounds(from, point, tolerance);
      if (nearest(value.low) == nearest(value.high))
      {
        return nearest(value.low);
      }
    }
  }
  return nearest(this->bounds(this->everything(), point, 0.0).low);
}

} // namespace medial

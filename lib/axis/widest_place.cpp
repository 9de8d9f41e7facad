#include "axis/widest_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// The distance must grow by more than this part of the way: across a flat tube it hardly changes,
/// and the facets of its surface would lead here and there.
constexpr double kMinSlope = 0.2;

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

} // namespace

void DistanceCuts::add(const glm::dvec2& place, double distance, const glm::dvec2& slope)
{
  cuts_[next_] = { distance - glm::dot(slope, place), slope };
  next_ = (next_ + 1) % kMost;
  count_ = std::min(count_ + 1, kMost);
}

double DistanceCuts::at(const glm::dvec2& place) const
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count_; ++i)
  {
    least = std::min(least, cuts_[i].height + glm::dot(cuts_[i].slope, place));
  }
  return least;
}

/// Takes a place if it is within reach and better than the best.
void DistanceCuts::offer(const glm::dvec2& place, const glm::dvec2& from, double reach,
  Place& best) const
{
  const double way = glm::distance(place, from);
  if (way <= reach * (1.0 + 1e-9))
  {
    const double value = this->at(place) - kMinSlope * way;
    if (value > best.value)
    {
      best = { place, value };
    }
  }
}

/// Offers a place on the line where two cuts are equal: the nearest one, or further on if they rise
/// along the line.
void DistanceCuts::offerRidge(const Cut& a, const Cut& b, const glm::dvec2& from, double reach,
  Place& best) const
{
  const glm::dvec2 normal = a.slope - b.slope;
  const double size = glm::dot(normal, normal);
  if (!(size > 0.0))
  {
    return;
  }
  const double difference = b.height - a.height - glm::dot(normal, from);
  const glm::dvec2 nearest = from + normal * (difference / size);
  const double off = glm::distance(nearest, from);
  if (off > reach)
  {
    return;
  }
  const glm::dvec2 along = glm::dvec2(-normal.y, normal.x) / std::sqrt(size);
  const double rise = glm::dot(a.slope, along);
  const double way = rise * std::sqrt(reach * reach - off * off);
  this->offer(nearest + way * along, from, reach, best);
}

/// Offers the place where three cuts are equal.
void DistanceCuts::offerTip(const Cut& a, const Cut& b, const Cut& c, const glm::dvec2& from,
  double reach, Place& best) const
{
  const glm::dvec2 ab = a.slope - b.slope;
  const glm::dvec2 ac = a.slope - c.slope;
  const double area = cross(ab, ac);
  const glm::dvec2 right(b.height - a.height, c.height - a.height);
  const glm::dvec2 tip(right.x * ac.y - right.y * ab.y, ab.x * right.y - ac.x * right.x);
  if (area != 0.0)
  {
    this->offer(tip / area, from, reach, best);
  }
}

glm::dvec2 DistanceCuts::widest(const glm::dvec2& from, double reach) const
{
  Place best{ from, this->at(from) };
  for (std::size_t i = 0; i < count_; ++i)
  {
    const double slope = glm::length(cuts_[i].slope);
    if (slope > kMinSlope)
    {
      this->offer(from + cuts_[i].slope * (reach / slope), from, reach, best);
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      this->offerRidge(cuts_[i], cuts_[j], from, reach, best);
      for (std::size_t k = 0; k < j; ++k)
      {
        this->offerTip(cuts_[i], cuts_[j], cuts_[k], from, reach, best);
      }
    }
  }
  return best.place;
}

} // namespace medial

#include "mesh/manifold_part.h"

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{

using Triangle = ManifoldPart::Triangle;

constexpr int kNone = -1;

/// An end of an edge: twice the edge, plus one at its higher point.
std::size_t endOf(int edge, int point, int otherPoint)
{
  return 2 * static_cast<std::size_t>(edge) + (point < otherPoint ? 0 : 1);
}

/// The ends of the two sides that meet at corner i.
std::array<std::size_t, 2> endsAt(const Triangle& corners, const Triangle& sides, int i)
{
  const int before = (i + 2) % 3;
  return { endOf(sides[before], corners[i], corners[before]),
    endOf(sides[i], corners[i], corners[(i + 1) % 3]) };
}

} // namespace

ManifoldPart::ManifoldPart(std::size_t points, int edges)
  : fans_(points, 0)
  , closed_(points, 0)
  , faces_(edges, 0)
  , starts_(edges, kNone)
  , fanEnds_(2 * static_cast<std::size_t>(edges))
{
  std::iota(fanEnds_.begin(), fanEnds_.end(), std::size_t{ 0 });
}

bool ManifoldPart::add(const Triangle& corners, const Triangle& sides)
{
  for (int i = 0; i < 3; ++i)
  {
    if (!this->fits(corners, sides, i))
    {
      return false;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    this->link(corners, sides, i);
  }
  for (int i = 0; i < 3; ++i)
  {
    ++faces_[sides[i]];
    starts_[sides[i]] = corners[i];
  }
  return true;
}

int ManifoldPart::pointsWithGaps() const
{
  return static_cast<int>(
    std::count_if(fans_.begin(), fans_.end(), [](int fans) { return fans > 1; }));
}

bool ManifoldPart::fits(const Triangle& corners, const Triangle& sides, int i) const
{
  const int faces = faces_[sides[i]];
  const bool taken = faces > 1 || (faces == 1 && starts_[sides[i]] == corners[i]);
  const auto [before, after] = endsAt(corners, sides, i);
  const bool closes = this->hasFace(before) && fanEnds_[before] == after;
  return closed_[corners[i]] == 0 && !taken && (!closes || fans_[corners[i]] == 1);
}

void ManifoldPart::link(const Triangle& corners, const Triangle& sides, int i)
{
  const auto [before, after] = endsAt(corners, sides, i);
  const std::size_t first = fanEnds_[before];
  const std::size_t last = fanEnds_[after];
  if (first == after)
  {
    closed_[corners[i]] = 1;
    return;
  }
  fans_[corners[i]] += 1 - (this->hasFace(before) ? 1 : 0) - (this->hasFace(after) ? 1 : 0);
  fanEnds_[first] = last;
  fanEnds_[last] = first;
}

} // namespace medial

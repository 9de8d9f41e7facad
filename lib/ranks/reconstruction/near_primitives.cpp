#include "ranks/reconstruction/near_primitives.h"

#include "base/id_limits.h"
#include "measure/reconstruction_field.h"
#include "ranks/collective.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

using Corners = std::array<std::int32_t, 3>;

constexpr std::int32_t kNone = -1;

bool reachesInto(const Bounds& bounds, const BallPrimitives& parts, const Corners& corners)
{
  Bounds own = kEmptyBounds;
  double reach = 0.0; // a hull of balls is no farther from its centres than the largest ball
  for (const std::int32_t corner : corners)
  {
    if (corner != kNone)
    {
      const Ball& ball = parts.balls[corner];
      const Point3 centre{ ball.centre.x, ball.centre.y, ball.centre.z };
      own = joined(own, { centre, centre });
      reach = std::max(reach, ball.radius);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (own.min[axis] - reach > bounds.max[axis] || own.max[axis] + reach < bounds.min[axis])
    {
      return false;
    }
  }
  return true;
}

/// Returns the primitives that reach into bounds, and the balls that they use.
BallPrimitives partWithin(const Bounds& bounds, const BallPrimitives& parts)
{
  BallPrimitives part;
  std::vector<std::int32_t> numbers(parts.balls.size(), kNone);
  for (Corners corners : parts.primitives)
  {
    if (!reachesInto(bounds, parts, corners))
    {
      continue;
    }
    for (std::int32_t& corner : corners)
    {
      if (corner == kNone)
      {
        continue;
      }
      std::int32_t& number = numbers[corner];
      if (number == kNone)
      {
        number = static_cast<std::int32_t>(part.balls.size());
        part.balls.push_back(parts.balls[corner]);
      }
      corner = number;
    }
    part.primitives.push_back(corners);
  }
  return part;
}

} // namespace

BallPrimitives nearPrimitives(Communicator& communicator, const BallPrimitives& own,
  const Grid& grid, const Extent& extent)
{
  const std::vector<Extent> extents = gathered(communicator, extent);
  RankLists<Ball> balls = listsFor<Ball>(communicator);
  RankLists<Corners> primitives = listsFor<Corners>(communicator);
  for (std::size_t rank = 0; rank < extents.size(); ++rank)
  {
    if (!extents[rank].empty())
    {
      BallPrimitives part = partWithin(reconstructionReach(grid, extents[rank]), own);
      balls[rank] = std::move(part.balls);
      primitives[rank] = std::move(part.primitives);
    }
  }
  balls = exchanged(communicator, std::move(balls));
  primitives = exchanged(communicator, std::move(primitives));
  std::int64_t first = 0;
  for (std::size_t rank = 0; rank < balls.size(); ++rank)
  {
    for (Corners& corners : primitives[rank])
    {
      for (std::int32_t& corner : corners)
      {
        corner = corner == kNone ? kNone : static_cast<std::int32_t>(corner + first);
      }
    }
    first += static_cast<std::int64_t>(balls[rank].size());
    requireCount("the medial model", first, "balls");
  }
  return { flattened(std::move(balls)), flattened(std::move(primitives)) };
}

} // namespace medial

#include "balls/ball_union.h"

#include "base/id_limits.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{

constexpr std::int32_t kNone = -1;

std::vector<Ball> ballsOf(const MedialModel& model)
{
  checkMedialModel(model);
  requireCount("the medial model", static_cast<std::int64_t>(model.centres.size()), "balls");
  std::vector<Ball> balls(model.centres.size());
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const Point3& centre = model.centres[i];
    balls[i] = { { centre[0], centre[1], centre[2] }, model.radii[i] };
  }
  return balls;
}

std::vector<std::array<std::int32_t, 3>> ballsAlone(std::size_t count)
{
  std::vector<std::array<std::int32_t, 3>> primitives;
  primitives.reserve(count);
  for (std::size_t ball = 0; ball < count; ++ball)
  {
    primitives.push_back({ static_cast<std::int32_t>(ball), kNone, kNone });
  }
  return primitives;
}

std::vector<std::array<std::int32_t, 3>> joinedBalls(const MedialModel& model)
{
  std::vector<std::array<std::int32_t, 3>> primitives;
  std::vector<char> joined(model.centres.size(), 0);
  const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c)
  {
    primitives.push_back(
      { static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c) });
    joined[a] = joined[b] = 1;
    joined[c == kNone ? a : c] = 1;
  };
  for (const auto& triangle : model.allTriangles())
  {
    add(triangle[0], triangle[1], triangle[2]);
  }
  for (const auto& line : model.lines)
  {
    add(line[0], line[1], kNone);
  }
  for (std::size_t ball = 0; ball < joined.size(); ++ball)
  {
    if (!joined[ball])
    {
      primitives.push_back({ static_cast<std::int32_t>(ball), kNone, kNone });
    }
  }
  return primitives;
}

ItemBounds boundsOf(const std::vector<Ball>& balls, const std::array<std::int32_t, 3>& primitive)
{
  ItemBounds bounds = ItemBounds::nothing();
  for (const std::int32_t ball : primitive)
  {
    if (ball != kNone)
    {
      bounds.add(balls[ball].centre, balls[ball].radius);
    }
  }
  return bounds;
}

std::vector<ItemBounds> boundsOf(const std::vector<Ball>& balls,
  const std::vector<std::array<std::int32_t, 3>>& primitives)
{
  std::vector<ItemBounds> bounds(primitives.size());
  std::transform(primitives.begin(), primitives.end(), bounds.begin(),
    [&balls](const auto& primitive) { return boundsOf(balls, primitive); });
  return bounds;
}

/// Returns the direction out of a ball; at its centre any will do.
glm::dvec3 outward(const Ball& ball, const glm::dvec3& x)
{
  const glm::dvec3 fromCentre = x - ball.centre;
  const double length = glm::length(fromCentre);
  return length > 0.0 ? fromCentre / length : glm::dvec3(1.0, 0.0, 0.0);
}

} // namespace

BallPrimitives primitivesOf(const MedialModel& model, bool interpolate)
{
  BallPrimitives parts;
  parts.balls = ballsOf(model);
  parts.primitives = interpolate ? joinedBalls(model) : ballsAlone(parts.balls.size());
  return parts;
}

BallUnion::BallUnion(const MedialModel& model, bool interpolate)
  : BallUnion(primitivesOf(model, interpolate))
{
}

BallUnion::BallUnion(BallPrimitives parts)
  : balls_(std::move(parts.balls))
  , primitives_(std::move(parts.primitives))
  , tree_(boundsOf(balls_, primitives_))
{
}

BallUnion::BallUnion(std::vector<Ball> balls)
  : balls_(std::move(balls))
  , primitives_(ballsAlone(balls_.size()))
  , tree_(boundsOf(balls_, primitives_))
{
}

HullDistance BallUnion::distanceTo(std::uint32_t primitive, const glm::dvec3& x, double limit) const
{
  const auto& [a, b, c] = primitives_[primitive];
  if (c != kNone)
  {
    return distanceToWedge(balls_[a], balls_[b], balls_[c], x, limit);
  }
  return b != kNone ? distanceToCone(balls_[a], balls_[b], x) : distanceToBall(balls_[a], x);
}

HullDistance BallUnion::nearest(const glm::dvec3& x, double limit) const
{
  HullDistance best;
  best.distance = limit;
  tree_.search(x, best.distance,
    [&](std::uint32_t primitive)
    {
      const HullDistance found = this->distanceTo(primitive, x, best.distance);
      if (found.distance < best.distance)
      {
        best = found;
      }
    });
  return best;
}

double BallUnion::distance(const glm::dvec3& x, double limit) const
{
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  tree_.search(x, limit,
    [&](std::uint32_t primitive)
    {
      const auto& [a, b, c] = primitives_[primitive];
      const double bound = c != kNone ? wedgeBound(balls_[a], balls_[b], balls_[c], x) : -kNoLimit;
      if (bound >= limit)
      {
        return;
      }
      const double found = this->distanceTo(primitive, x, kNoLimit).distance;
      if (found < limit)
      {
        // Not below what the tree's nodes are compared with.
        const double ofBox = boundsOf(balls_, primitives_[primitive]).minDistance(x);
        limit = std::min(limit, std::max({ found, bound, ofBox }));
      }
    });
  return limit;
}

bool BallUnion::covers(const glm::dvec3& x, double depth) const
{
  constexpr double kStop = -std::numeric_limits<double>::infinity();
  double limit = -depth;
  tree_.search(x, limit,
    [&](std::uint32_t primitive)
    {
      if (limit != kStop && this->distanceTo(primitive, x, -depth).distance < -depth)
      {
        limit = kStop;
      }
    });
  return limit == kStop;
}

double BallUnion::distanceToSurface(const glm::dvec3& x, double tolerance) const
{
  // In a narrow crease the moves zigzag between its walls and hardly advance; elsewhere they may go
  // round in a circle. Straight lines leave every bounded solid: the better of two goes on, one of
  // them where the moves drift to. kPeriod moves are several rounds of 2, 3 or 4 walls.
  constexpr int kMaxMoves = 64;
  constexpr int kPeriod = 12;
  HullDistance nearest = this->nearest(x);
  if (nearest.distance >= 0.0)
  {
    return nearest.distance;
  }
  glm::dvec3 y = x;
  glm::dvec3 earlier = x;
  for (int move = 0; move < kMaxMoves && nearest.distance < -tolerance; ++move)
  {
    earlier = move == kMaxMoves - kPeriod ? y : earlier;
    y -= nearest.distance * outward(nearest.ball, y);
    nearest = this->nearest(y);
  }
  if (nearest.distance >= -tolerance)
  {
    return glm::distance(x, y);
  }
  const glm::dvec3 end = this->wayOut(y, outward(nearest.ball, y), tolerance);
  const double distance = glm::distance(x, end);
  const double drift = glm::distance(earlier, y);
  return drift > tolerance
    ? std::min(distance, glm::distance(x, this->wayOut(y, (y - earlier) / drift, tolerance)))
    : distance;
}

glm::dvec3 BallUnion::wayOut(glm::dvec3 y, const glm::dvec3& direction, double tolerance) const
{
  constexpr int kMaxSteps = 100000;
  HullDistance nearest = this->nearest(y);
  for (int step = 0; step < kMaxSteps && nearest.distance < -tolerance; ++step)
  {
    y -= nearest.distance * direction;
    nearest = this->nearest(y);
  }
  return y;
}

} // namespace medial

#include "measure/ball_neighbours.h"

#include "base/sorted_set.h"
#include "measure/direction_patches.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

/// Directions hidden by less than this stay visible: the wedge and the cones that touch there
/// agree.
constexpr double kTolerance = 1e-12;

/// A cone, and the third ball of a wedge that has it as an edge; -1 for a line.
using ConeOfPrimitive = std::array<std::int32_t, 3>;

std::vector<ConeOfPrimitive> conesOf(const BallUnion& solid)
{
  std::vector<ConeOfPrimitive> cones;
  const auto add = [&cones](std::int32_t a, std::int32_t b, std::int32_t third) {
    cones.push_back({ std::min(a, b), std::max(a, b), third });
  };
  for (const auto& [a, b, c] : solid.primitives())
  {
    if (c >= 0)
    {
      add(a, b, c);
      add(b, c, a);
      add(c, a, b);
    }
    else if (b >= 0)
    {
      add(a, b, -1);
    }
  }
  makeSet(cones);
  return cones;
}

} // namespace

BallNeighbours::BallNeighbours(const BallUnion& solid)
{
  for (const auto& primitive : solid.primitives())
  {
    if (primitive[2] >= 0)
    {
      wedges_.push_back(primitive);
    }
  }
  this->collectCones(solid);

  const std::vector<Ball>& balls = solid.balls();
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  for (const auto& [a, b] : cones_)
  {
    pairs.emplace_back(a, b);
    pairs.emplace_back(b, a);
  }
  std::sort(pairs.begin(), pairs.end());
  ballOffsets_.assign(balls.size() + 1, 0);
  for (const auto& [ball, neighbour] : pairs)
  {
    ballCovers_.push_back(coverOf(balls[ball], balls[neighbour]));
    ++ballOffsets_[ball + 1];
  }
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    ballOffsets_[i + 1] += ballOffsets_[i];
  }
}

void BallNeighbours::collectCones(const BallUnion& solid)
{
  const std::vector<Ball>& balls = solid.balls();
  for (const auto& [a, b, third] : conesOf(solid))
  {
    if (cones_.empty() || cones_.back() != std::array<std::int32_t, 2>{ a, b })
    {
      cones_.push_back({ a, b });
      coneOffsets_.push_back(coneOffsets_.back());
    }
    if (third >= 0)
    {
      coneCovers_.push_back(coverOf(balls[a], balls[third]));
      ++coneOffsets_.back();
    }
  }
}

BallNeighbours::Cover BallNeighbours::coverOf(const Ball& ball, const Ball& neighbour)
{
  constexpr Cover kAll{ glm::dvec3(1.0, 0.0, 0.0), -2.0, -2.0 };
  constexpr Cover kNone{ glm::dvec3(1.0, 0.0, 0.0), 2.0, 2.0 };
  const glm::dvec3 along = neighbour.centre - ball.centre;
  const double distance = glm::length(along);
  const double shrink = ball.radius - neighbour.radius;
  if (shrink <= -distance)
  {
    return distance > 0.0 || shrink < 0.0 ? kAll : kNone;
  }
  if (shrink >= distance)
  {
    return kNone;
  }
  const double min = shrink / distance;
  const double reach = std::acos(min) - DirectionPatches::instance().radius();
  return { along / distance, min + kTolerance, reach > 0.0 ? std::cos(reach) : 2.0 };
}

bool BallNeighbours::ballHidden(std::int32_t ball, const glm::dvec3& normal) const
{
  return std::any_of(ballCovers_.begin() + ballOffsets_[ball],
    ballCovers_.begin() + ballOffsets_[ball + 1],
    [&normal](const Cover& cover) { return glm::dot(normal, cover.towards) > cover.min; });
}

bool BallNeighbours::patchHidden(std::int32_t ball, const glm::dvec3& centre) const
{
  return std::any_of(ballCovers_.begin() + ballOffsets_[ball],
    ballCovers_.begin() + ballOffsets_[ball + 1],
    [&centre](const Cover& cover) { return glm::dot(centre, cover.towards) > cover.minOfPatch; });
}

bool BallNeighbours::coneHidden(std::size_t cone, const glm::dvec3& normal) const
{
  return std::any_of(coneCovers_.begin() + coneOffsets_[cone],
    coneCovers_.begin() + coneOffsets_[cone + 1],
    [&normal](const Cover& cover) { return glm::dot(normal, cover.towards) > cover.min; });
}

} // namespace medial

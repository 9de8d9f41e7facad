#include "thickness/thickness_tile.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

constexpr float kUnwanted = std::numeric_limits<float>::infinity();
/// What rounding may add to the power of a point, in squares of the largest radius.
constexpr float kPowerMargin = 2e-6f;

} // namespace

ThicknessTile::ThicknessTile(const BallFamilies& families, const glm::vec3& first)
  : families_(families)
  , first_(first)
{
  radii_.step = families.step();
  std::fill_n(radii_.radius, kPoints, kUnwanted);
}

/// The rows with points that balls might raise.
RowMask ThicknessTile::rowsReached(const glm::vec3& low, const glm::vec3& high, float radius) const
{
  return radii_.rowsWithin(
    { low - first_, high - first_, this->reachOf(radius), roundedRadius(radius) });
}

/// Raises the radii to that of the ball that all families of an item have in common. Returns the
/// rows that the others might raise.
RowMask ThicknessTile::raiseByBall(const BallFamilies::Item& item)
{
  const glm::vec4& ball = families_.ballOf(item);
  const glm::vec3 centre(ball);
  const RowMask rows = this->rowsReached(centre - item.length, centre + item.length, item.reach);
  if (rows == 0)
  {
    return 0;
  }
  const RaisedRows raised = radii_.raise(CommonBall{ centre - first_, this->reachOf(ball.w),
                                           this->reachOf(item.reach) + item.length + kBallMargin,
                                           roundedRadius(ball.w), roundedRadius(item.reach) },
    rows);
  this->update(raised.changed);
  return raised.near;
}

/// Returns those of some rows with points that the families of an item might raise.
RowMask ThicknessTile::rowsNear(std::uint32_t number, RowMask rows)
{
  const BallFamilies::Item& item = families_.item(number);
  balls_.clear();
  const auto add = [&](const glm::vec4& ball)
  {
    const float reach = this->reachOf(ball.w);
    balls_.emplace_back(glm::vec3(ball) - first_, reach * reach);
  };
  add(families_.ballOf(item));
  for (std::uint32_t e = item.edgesBegin; e < families_.item(number + 1).edgesBegin; ++e)
  {
    add(families_.ball(families_.edges()[e][1]));
  }
  // For the ball with weights w_i the power is at least the mean of those of the corners, less the
  // sum of w_i w_j d_ij^2, which is the square of the radius of a ball around the corners at most.
  const float reach = this->reachOf(item.reach) + 1.0f;
  const float bump = item.length * item.length / 3.0f + kPowerMargin * reach * reach;
  return radii_.rowsNear(balls_.data(), balls_.size(), bump, roundedRadius(item.reach), rows);
}

void ThicknessTile::raiseBy(std::uint32_t number, RowMask rows)
{
  const BallFamilies::Item& item = families_.item(number);
  const BallFamilies::Item& next = families_.item(number + 1);
  RowMask changed = 0;
  for (std::uint32_t e = item.edgesBegin; e < next.edgesBegin; ++e)
  {
    const BallFamilies::Edge& edge = families_.edges()[e];
    const EdgeFamily family(families_.ball(edge[0]), families_.ball(edge[1]), first_, stretch_);
    changed |= radii_.raise(family, rows, 1.0f / stretch_);
  }
  for (std::uint32_t t = item.trianglesBegin; t < next.trianglesBegin; ++t)
  {
    const BallFamilies::Triangle& triangle = families_.triangles()[t];
    const TriangleFamily family(families_.ball(triangle[0]), families_.ball(triangle[1]),
      families_.ball(triangle[2]), first_, stretch_);
    if (family.counts)
    {
      changed |= radii_.raise(family, rows, 1.0f / stretch_);
    }
  }
  this->update(changed);
}

void ThicknessTile::update(RowMask changed)
{
  if (changed != 0)
  {
    limit_ = -static_cast<double>(radii_.updateRows(changed));
  }
}

void ThicknessTile::raise(const glm::vec3& centre, float radius, int slice)
{
  const float rounded = roundedRadius(radius);
  const CommonBall ball{ centre - first_, radius, 0.0f, rounded, rounded };
  const RowMask rows = ((RowMask{ 1 } << kRow) - 1) << (kRow * slice);
  this->update(radii_.raise(ball, rows).changed);
}

void ThicknessTile::raise(float stretch)
{
  stretch_ = stretch;
  this->update(~RowMask{ 0 });
  const BoundingTree& tree = families_.tree();
  const auto minimum = [&](std::uint32_t node)
  {
    const ItemBounds& bounds = tree.bounds(node);
    const auto reach = static_cast<float>(bounds.reach);
    return this->rowsReached(glm::vec3(bounds.min), glm::vec3(bounds.max), reach) != 0
      ? -static_cast<double>(roundedRadius(reach))
      : 0.0;
  };
  // Single balls are quick, and leave few points that families between them could raise.
  std::vector<std::pair<std::uint32_t, RowMask>> reached;
  tree.searchNodes(minimum, limit_,
    [&](std::uint32_t group)
    {
      const std::uint32_t end = families_.firstItem(group + 1);
      for (std::uint32_t item = families_.firstItem(group); item < end; ++item)
      {
        if (const RowMask rows = this->raiseByBall(families_.item(item)))
        {
          reached.emplace_back(item, rows);
        }
      }
    });
  for (const auto& [item, reachedRows] : reached)
  {
    const RowMask rows = reachedRows & radii_.rowsBelow(roundedRadius(families_.item(item).reach));
    if (rows != 0)
    {
      this->raiseBy(item, this->rowsNear(item, rows));
    }
  }
}

} // namespace medial

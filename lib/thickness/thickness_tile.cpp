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

/// Raises the radii to that of a ball that all families of an item have in common. Returns the rows
/// that the others might raise.
/// @param lane of the ball among those of its group.
RowMask ThicknessTile::raiseByBall(const BallRow& balls, std::uint32_t lane,
  const ReachedBalls& reached)
{
  const glm::vec3 centre = glm::vec3(balls.x[lane], balls.y[lane], balls.z[lane]) - first_;
  const float length = balls.length[lane];
  const float reach = this->reachOf(balls.reach[lane]);
  const RowMask rows =
    radii_.rowsWithin({ centre - length, centre + length, reach, reached.largest[lane] });
  if (rows == 0)
  {
    return 0;
  }
  const RaisedRows raised =
    radii_.raise(CommonBall{ centre, this->reachOf(balls.radius[lane]),
                   reach + length + kBallMargin, reached.radius[lane], reached.largest[lane] },
      rows);
  this->update(raised.changed);
  return raised.near;
}

/// Returns those of some rows with points that the families of an item might raise.
RowMask ThicknessTile::rowsNear(const ReachedItem& reached)
{
  const BallFamilies::Item& item = families_.item(reached.number);
  balls_.clear();
  const auto add = [&](std::uint32_t id)
  {
    const glm::vec4& ball = families_.ball(id);
    const float reach = this->reachOf(ball.w);
    balls_.emplace_back(glm::vec3(ball) - first_, reach * reach);
  };
  add(item.ball);
  for (std::uint32_t e = item.edgesBegin; e < families_.item(reached.number + 1).edgesBegin; ++e)
  {
    add(families_.edgeEnds()[e]);
  }
  // For the ball with weights w_i the power is at least the mean of those of the corners, less the
  // sum of w_i w_j d_ij^2, which is the square of the radius of a ball around the corners at most.
  const float reach = this->reachOf(reached.reach) + 1.0f;
  const float bump = reached.length * reached.length / 3.0f + kPowerMargin * reach * reach;
  return radii_.rowsNear(balls_.data(), balls_.size(), bump, reached.largest, reached.rows);
}

/// Raises the radii of the points in some rows to those of an item's families.
void ThicknessTile::raiseBy(std::uint32_t number, RowMask rows)
{
  const BallFamilies::Item& item = families_.item(number);
  const BallFamilies::Item& next = families_.item(number + 1);
  const glm::vec4& common = families_.ball(item.ball);
  const float least = radii_.minOf(rows);
  const float shrink = 1.0f / stretch_;
  RowMask changed = 0;
  for (std::uint32_t e = item.edgesBegin; e < next.edgesBegin; ++e)
  {
    const glm::vec4& end = families_.ball(families_.edgeEnds()[e]);
    if (EdgeFamily::largestOf(common, end) > least)
    {
      changed |= radii_.raise(EdgeFamily(common, end, first_, stretch_), rows, shrink);
    }
  }
  for (std::uint32_t t = item.trianglesBegin; t < next.trianglesBegin; ++t)
  {
    const auto& [second, third] = families_.triangleEnds()[t];
    const glm::vec4& a = families_.ball(second);
    const glm::vec4& b = families_.ball(third);
    if (TriangleFamily::largestOf(common, a, b) <= least)
    {
      continue;
    }
    const TriangleFamily family(common, a, b, first_, stretch_);
    if (family.counts)
    {
      changed |= radii_.raise(family, rows, shrink);
    }
  }
  this->update(changed);
}

void ThicknessTile::update(RowMask changed)
{
  if (changed != 0)
  {
    radii_.updateRows(changed);
    limit_ = -static_cast<double>(radii_.min);
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
  radii_.findBounds(kUnwanted);
  this->update(~RowMask{ 0 });
  const BoundingTree& tree = families_.tree();
  const auto minimum = [&](std::uint32_t node)
  {
    const ItemBounds& bounds = tree.bounds(node);
    const auto reach = static_cast<float>(bounds.reach);
    const float largest = roundedRadius(reach);
    const RowMask rows = radii_.rowsWithin({ glm::vec3(bounds.min) - first_,
      glm::vec3(bounds.max) - first_, this->reachOf(reach), largest });
    return rows != 0 ? -static_cast<double>(largest) : 0.0;
  };
  // Single balls are quick, and leave few points that families between them could raise.
  std::vector<ReachedItem> items;
  tree.searchNodes(minimum, limit_,
    [&](std::uint32_t group)
    {
      const BallRow& balls = families_.row(group);
      const ReachedBalls reached = radii_.ballsNear(balls, first_, stretch_);
      for (unsigned left = reached.lanes; left != 0; left &= left - 1)
      {
        const auto lane = static_cast<std::uint32_t>(__builtin_ctz(left));
        if (const RowMask rows = this->raiseByBall(balls, lane, reached))
        {
          items.push_back({ families_.firstItem(group) + lane, balls.reach[lane],
            balls.length[lane], reached.largest[lane], rows });
        }
      }
    });
  for (ReachedItem& item : items)
  {
    item.rows &= radii_.rowsBelow(item.largest);
    item.rows = item.rows != 0 ? this->rowsNear(item) : 0;
    if (item.rows != 0)
    {
      this->raiseBy(item.number, item.rows);
    }
  }
}

} // namespace medial

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
  , radii_(families.places())
{
  std::fill_n(radii_.radius, kPoints, kUnwanted);
}

/// Raises the radii to that of a ball that all families of an item have in common. Returns the
/// blocks that the others might raise.
/// @param lane of the ball among those of its group.
BlockMask ThicknessTile::raiseByBall(const BallGroup& balls, std::uint32_t lane,
  const ReachedBalls& reached)
{
  const glm::vec3 centre = glm::vec3(balls.x[lane], balls.y[lane], balls.z[lane]) - first_;
  const glm::vec3 middle =
    glm::vec3(balls.middleX[lane], balls.middleY[lane], balls.middleZ[lane]) - first_;
  const float span = this->reachOf(balls.span[lane]);
  const BlockMask blocks = radii_.blocksWithin({ middle, middle, span, reached.largest[lane] });
  if (blocks == 0)
  {
    return 0;
  }
  const RaisedBlocks raised =
    radii_.raise(CommonBall{ centre, this->reachOf(balls.radius[lane]), middle, span,
                   reached.radius[lane], reached.largest[lane] },
      blocks);
  this->update(raised.changed);
  return raised.near;
}

/// Returns those of some blocks with points that the families of an item might raise.
BlockMask ThicknessTile::blocksNear(const ReachedItem& reached)
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
  const float reach = this->reachOf(reached.span) + 1.0f;
  const float bump = reached.length * reached.length / 3.0f + kPowerMargin * reach * reach;
  return radii_.blocksNear(balls_.data(), balls_.size(), bump, reached.largest, reached.blocks);
}

/// Raises the radii of the points in some blocks to those of an item's families.
void ThicknessTile::raiseBy(std::uint32_t number, BlockMask blocks)
{
  const BallFamilies::Item& item = families_.item(number);
  const BallFamilies::Item& next = families_.item(number + 1);
  const glm::vec4& common = families_.ball(item.ball);
  const float least = radii_.minOf(blocks);
  const float shrink = 1.0f / stretch_;
  BlockMask changed = 0;
  for (std::uint32_t e = item.edgesBegin; e < next.edgesBegin; ++e)
  {
    const glm::vec4& end = families_.ball(families_.edgeEnds()[e]);
    if (EdgeFamily::largestOf(common, end) > least)
    {
      changed |= radii_.raise(EdgeFamily(common, end, first_, stretch_), blocks, shrink);
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
      changed |= radii_.raise(family, blocks, shrink);
    }
  }
  this->update(changed);
}

void ThicknessTile::update(BlockMask changed)
{
  if (changed != 0)
  {
    radii_.updateBlocks(changed);
    limit_ = -static_cast<double>(radii_.min);
  }
}

void ThicknessTile::raise(const glm::vec3& centre, float radius, int slice)
{
  this->update(radii_.raiseSlice(centre - first_, radius, roundedRadius(radius), slice));
}

void ThicknessTile::raise(float stretch)
{
  stretch_ = stretch;
  radii_.findBounds(kUnwanted);
  this->update(~BlockMask{ 0 });
  const BoundingTree& tree = families_.tree();
  const auto minimum = [&](std::uint32_t node)
  {
    const ItemBounds& bounds = tree.bounds(node);
    const auto reach = static_cast<float>(bounds.reach);
    const float largest = roundedRadius(reach);
    const BlockMask blocks = radii_.blocksWithin({ glm::vec3(bounds.min) - first_,
      glm::vec3(bounds.max) - first_, this->reachOf(reach), largest });
    return blocks != 0 ? -static_cast<double>(largest) : 0.0;
  };
  // Single balls are quick, and leave few points that families between them could raise.
  std::vector<ReachedItem> items;
  tree.searchNodes(minimum, limit_,
    [&](std::uint32_t group)
    {
      const BallGroup& balls = families_.group(group);
      const ReachedBalls reached = radii_.ballsNear(balls, first_, stretch_);
      for (unsigned left = reached.lanes; left != 0; left &= left - 1)
      {
        const auto lane = static_cast<std::uint32_t>(__builtin_ctz(left));
        if (const BlockMask blocks = this->raiseByBall(balls, lane, reached))
        {
          items.push_back({ families_.firstItem(group) + lane, balls.span[lane], balls.length[lane],
            reached.largest[lane], blocks });
        }
      }
    });
  for (ReachedItem& item : items)
  {
    item.blocks &= radii_.blocksBelow(item.largest);
    item.blocks = item.blocks != 0 ? this->blocksNear(item) : 0;
    if (item.blocks != 0)
    {
      this->raiseBy(item.number, item.blocks);
    }
  }
}

} // namespace medial

#include "field/engines/processor/point_evaluator.h"

#include "base/extents.h"
#include "culling/extent_hull.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{

/// Number of grid points along an edge of a brick. Smaller ones spend more on finding their groups
/// than they save.
constexpr int kBrickSize = 4;

/// Returns the part of a triangle that is nearest to a position, as the number of its bit in
/// SitePart.
MEDIAL_VECTORISED int nearestPart(const SiteGroup& group, int lane, const glm::dvec3& x)
{
  constexpr int kFirstEdge = 1;
  constexpr int kCorners[3][2] = { { 4, 5 }, { 5, 6 }, { 4, 6 } };
  const ElementPosition position(group, group.toGroup(x));
  if (position.offFace[lane] <= 0.0f)
  {
    return 0;
  }
  int part = 0;
  float least = std::numeric_limits<float>::infinity();
  for (int edge = 0; edge < 3; ++edge)
  {
    const float before = position.before[edge][lane];
    const float beyond = position.beyond[edge][lane];
    const float past = std::max(std::max(before, beyond), 0.0f);
    const float outside = position.outside[edge][lane];
    const float squared = past * past + outside * outside;
    if (squared < least)
    {
      least = squared;
      part =
        before > 0.0f ? kCorners[edge][0] : (beyond > 0.0f ? kCorners[edge][1] : kFirstEdge + edge);
    }
  }
  return part;
}

/// Returns the site that is nearest in an element.
int nearestSite(const GroupTree& tree, const NearestElement& nearest, const glm::dvec3& x)
{
  const SiteGroup& group = tree.groups()[nearest.group];
  return group.withoutFace[nearest.lane] == 0.0f
    ? siteOf(tree.sites(), group, nearest.lane, nearestPart(group, nearest.lane, x))
    : closestPoint(tree.sites(), group.elements[nearest.lane], x).site;
}

} // namespace

PointEvaluator::PointEvaluator(const GroupTree& tree, const GridFrame& frame)
  : tree_(tree)
  , frame_(frame)
{
}

std::int64_t PointEvaluator::evaluateBrick(const Extent& brick, const Extent& tile,
  const GroupList& groups, NearestElement nearest, TileField& field) const
{
  std::int64_t groupsTried = 0;
  for (int k = brick.min[2]; k <= brick.max[2]; ++k)
  {
    for (int j = brick.min[1]; j <= brick.max[1]; ++j)
    {
      for (int i = brick.min[0]; i <= brick.max[0]; ++i)
      {
        const glm::dvec3 x = frame_.sample(glm::dvec3(i, j, k));
        NearestElement start;
        start.tryGroup(tree_.groups(), nearest.group, x);
        nearest = groups.nearest(tree_.groups(), x, start);
        groupsTried += nearest.tried;
        const int index = TileField::index(i - tile.min[0], j - tile.min[1], k - tile.min[2]);
        field.squared[index] = nearest.squared;
        field.site[index] = nearestSite(tree_, nearest, x);
      }
    }
  }
  return groupsTried * SiteGroup::kSize;
}

std::int64_t PointEvaluator::evaluate(const Extent& tile, const GroupList& candidates,
  const SliceRange& slices, TileField& field, GroupList& brickGroups) const
{
  std::int64_t evaluated = 0;
  visitParts(tile, kBrickSize,
    [&](const Extent& brick)
    {
      if (brick.max[2] < tile.min[2] + slices.begin || brick.min[2] >= tile.min[2] + slices.end)
      {
        return;
      }
      NearestElement nearest;
      refine(tree_, candidates, hullOf(brick, frame_), nearest, brickGroups);
      evaluated += this->evaluateBrick(brick, tile, brickGroups, nearest, field);
    });
  return evaluated;
}

} // namespace medial

#include "field/engines/processor/point_evaluator.h"

#include "culling/extent_parts.h"
#include "sites/closest_point.h"

namespace medial
{
namespace
{

/// Number of grid points along an edge of a brick. Smaller ones spend more on finding their groups
/// than they save.
constexpr int kBrickSize = 4;

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
        const int element = tree_.groups()[nearest.group].elements[nearest.lane];
        const SitePoint closest = closestPoint(tree_.sites(), element, x);
        const int index = TileField::index(i - tile.min[0], j - tile.min[1], k - tile.min[2]);
        field.squared[index] = static_cast<float>(glm::dot(closest.point - x, closest.point - x));
        field.site[index] = closest.site;
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

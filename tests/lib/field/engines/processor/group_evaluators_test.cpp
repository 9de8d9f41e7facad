#include "base/extents.h"
#include "culling/candidate_filter.h"
#include "culling/extent_hull.h"
#include "culling/site_query.h"
#include "field/engines/processor/brick_evaluator.h"
#include "field/engines/processor/exact_points.h"
#include "field/engines/processor/point_evaluator.h"

#include "support/culling_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace medial::test
{
namespace
{

/// Tiles of a grid, with the groups of elements that they need.
class GroupsOf : public CullingTest
{
protected:
  using Evaluate = std::function<void(const Extent& tile, const BoxReach& reach,
    const GroupList& groups, const SliceRange& slices, TileField& field)>;

  /// Compares all tiles of the grid with exact queries.
  void expectExact(const Evaluate& evaluate) const
  {
    const GroupTree& tree = filter_.tree();
    const SiteQuery query(tree);
    auto field = std::make_unique<TileField>();
    GroupList groups;
    visitParts(grid_.wholeExtent(), TileField::kRow,
      [&](const Extent& tile)
      {
        const FrameBox hull = hullOf(tile, frame_);
        const BoxReach reach(hull, tree.nearest(glm::dvec3(hull.centre)), tree.slack());
        tree.collect(reach, groups);
        // Slices must not depend on those asked for.
        const SliceRange slices{ std::min(1, tile.size(2) - 1), tile.size(2) };
        evaluate(tile, reach, groups, slices, *field);
        visitParts(tile, 1,
          [&](const Extent& point)
          {
            if (slices.contains(point.min[2] - tile.min[2]))
            {
              this->expectClosest(tile, point, query, *field);
            }
          });
      });
  }

  void expectClosest(const Extent& tile, const Extent& point, const SiteQuery& query,
    const TileField& field) const
  {
    const auto& [i, j, k] = point.min;
    const int index = TileField::index(i - tile.min[0], j - tile.min[1], k - tile.min[2]);
    const glm::dvec3 x = frame_.sample(glm::dvec3(i, j, k));
    const double truth = glm::distance(query.closest(x).point, x);
    ASSERT_GE(field.site[index], 0);
    EXPECT_NEAR(std::sqrt(static_cast<double>(field.squared[index])), truth, 1e-3);
    EXPECT_NEAR(glm::distance(closestPoint(sites_, field.site[index], x).point, x), truth, 1e-3);
  }

  const CandidateFilter filter_{ sites_, connectivity_, frame_ };
};

} // namespace

TEST_P(GroupsOf, BricksAreExact)
{
  const BrickEvaluator bricks(filter_.tree(), frame_, filter_.slack());
  BrickEvaluator::Workspace workspace;
  expectExact([&](const Extent& tile, const BoxReach& reach, const GroupList& groups,
                const SliceRange& slices, TileField& field)
    { EXPECT_GT(bricks.evaluate(tile, reach, groups, slices, field, workspace), 0); });
}

TEST_P(GroupsOf, PointsAreExact)
{
  const PointEvaluator points(filter_.tree(), frame_);
  GroupList brickGroups;
  expectExact(
    [&](const Extent& tile, const BoxReach&, const GroupList& groups, const SliceRange& slices,
      TileField& field) { points.evaluate(tile, groups, slices, field, brickGroups); });
}

TEST_P(GroupsOf, GapsAreFilledExactly)
{
  const ExactPoints exact(SiteQuery(filter_.tree()), frame_);
  expectExact(
    [&](const Extent& tile, const BoxReach&, const GroupList&, const SliceRange& slices,
      TileField& field)
    {
      std::fill(std::begin(field.site), std::end(field.site), -1);
      EXPECT_TRUE(exact.fill(tile, slices, field));
      EXPECT_FALSE(exact.fill(tile, slices, field));
    });
}

INSTANTIATE_TEST_SUITE_P(Meshes, GroupsOf, testing::ValuesIn(cullingCases()), kNameOfParameter);

} // namespace medial::test

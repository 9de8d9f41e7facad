#include "culling/block_positions.h"

#include "culling/group_tree.h"
#include "culling/site_query.h"
#include "sites/closest_point.h"

#include "support/brute_force.h"
#include "support/culling_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

constexpr float kSlack = 1e-3f;

/// A block of positions, and the sites that are found for each of them.
struct FoundSites
{
  std::vector<glm::dvec3> positions;
  std::vector<std::vector<int>> sites;

  /// @param knownAt returns the distance of the known point.
  template <typename KnownAt>
  FoundSites(const SiteSet& set, const GroupTree& tree, const glm::dvec3& centre,
    std::vector<glm::dvec3> block, const KnownAt& knownAt)
    : positions(std::move(block))
    , sites(positions.size())
  {
    BlockPositions lanes;
    lanes.clear();
    for (const glm::dvec3& x : positions)
    {
      lanes.add(glm::vec3(x - centre), static_cast<float>(knownAt(x)) * (1.0f + 1e-6f));
    }
    BlockPositions::NearList near;
    for (const SiteGroup& group : tree.groups())
    {
      const int count = lanes.find(group, 0xffu, glm::vec3(group.origin - centre), kSlack, near);
      for (int i = 0; i < count; ++i)
      {
        this->add(set, group, near[i]);
      }
    }
  }

  void add(const SiteSet& set, const SiteGroup& group, const BlockPositions::Near& near)
  {
    for (int lane = 0; lane < kLanes; ++lane)
    {
      for (int part = 0; part < 7 && (near.positions >> lane & 1u) != 0; ++part)
      {
        if ((near.parts[lane] >> part & 1) != 0)
        {
          sites[near.first + lane].push_back(siteOf(set, group, near.element, part));
        }
      }
    }
  }
};

class BlockPositionsOf : public CullingTest
{
protected:
  /// Positions around the middle of the grid's cell that has an index.
  std::vector<glm::dvec3> around(const Point3& index, std::size_t count) const
  {
    Bounds bounds{};
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds.min[axis] = index[axis] - 2.0;
      bounds.max[axis] = index[axis] + 2.0;
    }
    return this->randomPositions(bounds, static_cast<int>(count), 5);
  }

  /// Grid points.
  std::vector<Point3> places() const
  {
    Bounds bounds{};
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds.max[axis] = grid_.dimensions[axis];
    }
    return randomPoints(bounds, 20, 7);
  }

  const GroupTree tree_{ sites_, connectivity_, kSlack };
  const SiteQuery query_{ tree_ };
};

/// Meshes of which every site has a region that bounds it.
class BlockPositionsOfSureSites : public BlockPositionsOf
{
};

std::vector<CullingCase> sureCases()
{
  std::vector<CullingCase> cases = cullingCases();
  const auto unsure = [](const CullingCase& culling) { return culling.name == "filledSplits"; };
  cases.erase(std::remove_if(cases.begin(), cases.end(), unsure), cases.end());
  return cases;
}

} // namespace

/// Whatever the number of positions, and whether the known point is the closest or another one.
TEST_P(BlockPositionsOf, FindsTheClosestSites)
{
  std::size_t count = 1;
  for (const Point3& place : this->places())
  {
    const std::vector<glm::dvec3> block = this->around(place, count);
    const int any = static_cast<int>(count) % sites_.size();
    count = count % BlockPositions::kMax + 3;
    count = std::min<std::size_t>(count, BlockPositions::kMax);
    for (const bool closestIsKnown : { true, false })
    {
      const FoundSites found(sites_, tree_, block.front(), block,
        [&](const glm::dvec3& x)
        {
          const SitePoint known = closestIsKnown ? query_.closest(x) : closestPoint(sites_, any, x);
          return glm::distance(known.point, x);
        });
      for (std::size_t i = 0; i < block.size(); ++i)
      {
        const glm::dvec3& x = block[i];
        double min = std::numeric_limits<double>::infinity();
        for (const int site : found.sites[i])
        {
          min = std::min(min, glm::distance(closestPoint(sites_, site, x).point, x));
        }
        EXPECT_EQ(min, glm::distance(query_.closest(x).point, x));
      }
    }
  }
}

/// Sites beyond the known point, and beside their Voronoi regions, are left out.
TEST_P(BlockPositionsOfSureSites, AreFew)
{
  std::size_t positions = 0;
  std::size_t found = 0;
  for (const Point3& place : this->places())
  {
    const std::vector<glm::dvec3> block = this->around(place, BlockPositions::kMax);
    const auto distance = [&](const glm::dvec3& x)
    { return glm::distance(query_.closest(x).point, x); };
    const FoundSites near(sites_, tree_, block.front(), block, distance);
    for (std::size_t i = 0; i < block.size(); ++i)
    {
      for (const int site : near.sites[i])
      {
        const glm::dvec3& x = block[i];
        EXPECT_LE(glm::distance(closestPoint(sites_, site, x).point, x), distance(x) + 0.01);
      }
      found += near.sites[i].size();
      ++positions;
    }
  }
  EXPECT_LE(found, 3 * positions);
}

INSTANTIATE_TEST_SUITE_P(Meshes, BlockPositionsOf, testing::ValuesIn(cullingCases()),
  kNameOfParameter);

INSTANTIATE_TEST_SUITE_P(Meshes, BlockPositionsOfSureSites, testing::ValuesIn(sureCases()),
  kNameOfParameter);

} // namespace medial::test

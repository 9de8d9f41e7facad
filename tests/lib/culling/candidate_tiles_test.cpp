#include "culling/candidate_tiles.h"

#include "base/extents.h"
#include "culling/extent_hull.h"
#include "sites/closest_point.h"
#include "sites/site_set.h"

#include "support/brute_force.h"
#include "support/culling_test.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Sites count as equally close within this, in local units.
constexpr double kTie = 1e-3;

/// A tile and its candidates, ascending.
struct TileSites
{
  Extent tile;
  std::vector<int> sites;
};

/// The tiles that a slab cuts, in any order.
std::vector<TileSites> listTiles(const CandidateHierarchy& hierarchy, const CandidateFilter& filter,
  const GridFrame& frame, const Extent& slab)
{
  std::vector<TileSites> tiles;
  std::mutex mutex;
  const auto add = [&](const Extent& tile, const std::vector<int>& sites)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    tiles.push_back({ tile, sites });
  };
  const auto addGroups = [&](const Extent& tile, const BoxReach& reach, const GroupList& groups)
  {
    const FrameBox hull = hullOf(tile, frame);
    std::vector<int> sites;
    CandidateFilter::Scratch scratch;
    filter.listSites(reach, groups, &hull, 1, &sites, scratch);
    add(tile, sites);
  };
  hierarchy.visitTiles(slab, { add, addGroups });
  return tiles;
}

class CandidateTilesOf : public CullingTest
{
protected:
  /// Whether one of the ids, ascending, is a site whose own interior holds the closest point.
  bool holdsClosest(const glm::dvec3& x, const int* begin, const int* end) const
  {
    double min = 1e300;
    std::vector<std::pair<double, int>> own;
    for (int site = 0; site < sites_.size(); ++site)
    {
      const SitePoint closest = closestPoint(sites_, site, x);
      const double distance = glm::distance(closest.point, x);
      min = std::min(min, distance);
      if (closest.site == site && sites_.active(site))
      {
        own.emplace_back(distance, site);
      }
    }
    return std::any_of(own.begin(), own.end(),
      [&](const auto& candidate) {
        return candidate.first <= min + kTie && std::binary_search(begin, end, candidate.second);
      });
  }

  /// Tiles of all slabs and blocks, each of which `check` must accept.
  template <class Check>
  void forEachTile(int slabSlices, Check check) const
  {
    const Extent whole = grid_.wholeExtent();
    const CandidateHierarchy hierarchy(filter_, frame_, whole, whole);
    for (int first = 0; first <= whole.max[2]; first += slabSlices)
    {
      Extent slab = whole;
      slab.min[2] = first;
      slab.max[2] = std::min(first + slabSlices - 1, whole.max[2]);
      for (const auto& [tile, sites] : listTiles(hierarchy, filter_, frame_, slab))
      {
        check(commonPart(tile, slab), sites.data(), sites.data() + sites.size());
      }
    }
  }

  const CandidateFilter filter_{ sites_, connectivity_, frame_ };
};

std::vector<glm::dvec3> indicesOf(const Extent& extent)
{
  std::vector<glm::dvec3> indices;
  for (int k = extent.min[2]; k <= extent.max[2]; ++k)
  {
    for (int j = extent.min[1]; j <= extent.max[1]; ++j)
    {
      for (int i = extent.min[0]; i <= extent.max[0]; ++i)
      {
        indices.emplace_back(i, j, k);
      }
    }
  }
  return indices;
}

} // namespace

TEST_P(CandidateTilesOf, HoldTheClosestSiteOfEveryPoint)
{
  std::atomic<int> missing{ 0 };
  forEachTile(64,
    [&](const Extent& tile, const int* begin, const int* end)
    {
      const std::vector<glm::dvec3> indices = indicesOf(tile);
      parallelFor(indices.size(),
        [&](std::size_t i)
        { missing += holdsClosest(frame_.sample(indices[i]), begin, end) ? 0 : 1; });
    });
  EXPECT_EQ(missing, 0);
}

TEST_P(CandidateTilesOf, CoverEveryPointOnceInAscendingOrder)
{
  for (const int slabSlices : { 1, 4, 8, 16, 64 })
  {
    std::vector<int> covered(static_cast<std::size_t>(grid_.pointCount()), 0);
    forEachTile(slabSlices,
      [&](const Extent& tile, const int* begin, const int* end)
      {
        EXPECT_LT(begin, end);
        EXPECT_TRUE(std::is_sorted(begin, end));
        EXPECT_EQ(std::adjacent_find(begin, end), end);
        for (const glm::dvec3& p : indicesOf(tile))
        {
          const auto& n = grid_.dimensions;
          ++covered[static_cast<std::size_t>(p.x + n[0] * (p.y + n[1] * p.z))];
        }
      });
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), grid_.pointCount());
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, CandidateTilesOf, testing::ValuesIn(cullingCases()),
  kNameOfParameter);

TEST(CandidateTiles, LeaveMostSitesOut)
{
  const TriangleMesh mesh = torus(1.0, 0.4, 60, 30);
  const Grid grid = makeGrid(mesh.bounds(), 64, 0.1);
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const SiteSet sites(mesh, connectivity, GridFrame(grid));
  const CandidateFilter filter(sites, connectivity, GridFrame(grid));
  const CandidateHierarchy hierarchy(filter, GridFrame(grid), grid.wholeExtent(),
    grid.wholeExtent());
  std::size_t tiles = 0;
  std::size_t pairs = 0;
  for (const auto& [tile, candidates] :
    listTiles(hierarchy, filter, GridFrame(grid), grid.wholeExtent()))
  {
    ++tiles;
    pairs += candidates.size();
  }
  EXPECT_LT(pairs, tiles * static_cast<std::size_t>(sites.size()) / 40);
}

#include "field/engines/processor/tile_evaluator.h"

#include "culling/candidate_filter.h"
#include "sites/closest_point.h"
#include "sites/pseudonormals.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

namespace medial::test
{
namespace
{

/// Tiles of a torus on a small grid, with any candidates.
class EvaluatedTile : public testing::Test
{
protected:
  /// Compares a tile with exact distances to the closed candidates, and returns how many are
  /// negative.
  int expectExact(const Extent& tile, const std::vector<int>& candidates)
  {
    auto field = std::make_unique<TileField>();
    evaluator_.evaluate(tile, candidates.data(), candidates.size(), { 0, tile.size(2) }, *field);
    int inside = 0;
    for (int k = 0; k < tile.size(2); ++k)
    {
      for (int j = 0; j < tile.size(1); ++j)
      {
        for (int i = 0; i < tile.size(0); ++i)
        {
          const glm::dvec3 x = frame_.sample({ tile.min[0] + i, tile.min[1] + j, tile.min[2] + k });
          const int index = TileField::index(i, j, k);
          const double truth = minDistance(candidates, x);
          EXPECT_NEAR(std::sqrt(static_cast<double>(field->squared[index])), truth, 1e-3);
          const int site = field->site[index];
          EXPECT_NEAR(glm::distance(closestPoint(sites_, site, x).point, x), truth, 1e-3);
          EXPECT_NEAR(glm::length(evaluator_.displacement(site, x)), truth, 1e-3);
          inside += field->side[index] < 0.0f ? 1 : 0;
        }
      }
    }
    return inside;
  }

  double minDistance(const std::vector<int>& candidates, const glm::dvec3& x) const
  {
    double min = 1e300;
    for (const int site : candidates)
    {
      min = std::min(min, glm::distance(closestPoint(sites_, site, x).point, x));
    }
    return min;
  }

  TriangleMesh mesh_ = torus(1.0, 0.4, 16, 8);
  Grid grid_ = makeGrid(mesh_.bounds(), 40);
  GridFrame frame_{ grid_ };
  MeshConnectivity connectivity_ = analyseConnectivity(mesh_);
  SiteSet sites_{ mesh_, connectivity_, frame_ };
  std::vector<glm::vec4> normals_ = pseudonormals(sites_, false);
  SiteBounds bounds_{ sites_, connectivity_ };
  TileEvaluator evaluator_{ sites_, bounds_, normals_, frame_,
    CandidateFilter(sites_, connectivity_, frame_).slack() };
};

TEST_F(EvaluatedTile, HoldsTheClosestOfAllSites)
{
  std::vector<int> all(sites_.size());
  std::iota(all.begin(), all.end(), 0);
  // The tube passes x = 1: a tile amid it, one through its surface, a thin and a single point.
  const auto at = [&](double x)
  { return static_cast<int>((x - grid_.origin[0]) / grid_.spacing[0]); };
  const int middle = grid_.dimensions[1] / 2;
  const int layer = grid_.dimensions[2] / 2;
  EXPECT_EQ(expectExact({ { at(1.0), middle, layer }, { at(1.0) + 1, middle + 2, layer } }, all),
    6);
  const int cut = expectExact(
    { { at(1.3), middle - 4, layer - 3 }, { at(1.3) + 7, middle + 3, layer + 4 } }, all);
  EXPECT_GT(cut, 0);
  EXPECT_LT(cut, 512);
  expectExact({ { 0, 0, 0 }, { 7, 0, 3 } }, all);
  EXPECT_EQ(expectExact({ { 1, 2, 3 }, { 1, 2, 3 } }, all), 0);
}

TEST_F(EvaluatedTile, PointsThatItsCandidatesExcludeHaveNoSite)
{
  const Extent tile{ { 3, 3, 3 }, { 10, 10, 8 } };
  const int edge = sites_.firstEdge() + 3; // the tile is beyond its ends
  auto field = std::make_unique<TileField>();
  evaluator_.evaluate(tile, &edge, 1, { 0, tile.size(2) }, *field);
  EXPECT_EQ(field->site[TileField::index(0, 0, 0)], -1);
}

} // namespace
} // namespace medial::test

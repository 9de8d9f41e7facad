#include "medial/compute_distance_field.h"
#include "medial/ranks.h"

#include "field_of_ranks.h"
#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

// How a grid is cut into a part for each rank.

namespace medial::test
{
namespace
{

/// The parts that ranks agree on.
std::vector<Extent> partsOfRanks(const FieldCase& of, int ranks, Side side = Side::Both)
{
  std::vector<std::vector<Extent>> parts(static_cast<std::size_t>(ranks));
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      parts[rank] = partsByWork(communicator, pieceOf(of.mesh, rank, atRandom(ranks)), of.grid,
        optionsOf(of), side);
    });
  for (const std::vector<Extent>& own : parts)
  {
    EXPECT_EQ(own.size(), parts.size());
    EXPECT_TRUE(std::equal(own.begin(), own.end(), parts[0].begin(), parts[0].end(),
      [](const Extent& a, const Extent& b) { return a.min == b.min && a.max == b.max; }));
  }
  return parts.front();
}

/// The work of the rank that has most, in shares of an equal part.
double busiest(const FieldCase& of, const std::vector<Extent>& extents)
{
  const auto ranks = static_cast<int>(extents.size());
  std::vector<double> work(extents.size());
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      NoField sink;
      const RunStatistics statistics = computeDistanceField(communicator,
        pieceOf(of.mesh, rank, atRandom(ranks)), of.grid, extents[rank], sink, optionsOf(of));
      work[rank] = static_cast<double>(
        statistics.groupTests + statistics.candidatePairs + statistics.fragments);
    });
  return ranks * *std::max_element(work.begin(), work.end()) /
    std::accumulate(work.begin(), work.end(), 0.0);
}

std::int64_t pointsOf(const std::vector<Extent>& extents)
{
  return std::accumulate(extents.begin(), extents.end(), std::int64_t{ 0 },
    [](std::int64_t points, const Extent& extent) { return points + extent.pointCount(); });
}

TEST(PartsByWork, TakeAboutTheSame)
{
  // All triangles are in a corner, where equal parts would leave one rank most of the work.
  const TriangleMesh mesh =
    numbered(appended(box({ 1.5, 1.4, 1.3 }), translated(icosphere(0.2, 5), { 0.9, 0.8, 0.7 })));
  const FieldCase of{ mesh, gridAround(mesh, 130) };
  constexpr int kRanks = 6;
  const std::vector<Extent> extents = partsOfRanks(of, kRanks);
  // The grid has 17 tiles along an edge: there is little choice where to cut.
  EXPECT_LT(busiest(of, extents), 0.75 * busiest(of, partsOfGrid(of.grid, kRanks)));
  expectSameBits(of, wholeFieldOf(of), extents, atRandom(kRanks));
}

TEST(PartsByWork, LookAtOneSideAlone)
{
  const TriangleMesh mesh = numbered(icosphere(1.0, 3));
  FieldCase of{ mesh, gridAround(mesh, 60), SignMethod::Winding };
  of.grid.dimensions = { 160, 160, 160 }; // most of it is empty
  constexpr int kRanks = 4;
  const auto ranksInside = [&](Side side)
  {
    const std::vector<Extent> extents = partsOfRanks(of, kRanks, side);
    return std::count_if(extents.begin(), extents.end(),
      [](const Extent& extent) {
        return !extent.empty() && extent.min[0] < 52 && extent.min[1] < 52 && extent.min[2] < 52;
      });
  };
  EXPECT_EQ(ranksInside(Side::Interior), kRanks);
  EXPECT_LT(ranksInside(Side::Both), kRanks);
}

TEST(PartsByWork, MayBeEmpty)
{
  const TriangleMesh mesh = numbered(icosphere(1.0, 1));
  const FieldCase of{ mesh, gridAround(mesh, 12) };
  const std::vector<Extent> extents = partsOfRanks(of, 16);
  expectSameBits(of, wholeFieldOf(of), extents, atRandom(16));
  EXPECT_EQ(pointsOf(extents), of.grid.pointCount());
}

TEST(PartsOfGrid, CoverItOnceAndEndWithTiles)
{
  for (const std::array<int, 3>& dimensions : { std::array<int, 3>{ 100, 64, 33 },
         std::array<int, 3>{ 20, 3, 5 }, std::array<int, 3>{ 1, 1, 1 } })
  {
    Grid grid;
    grid.dimensions = dimensions;
    for (const int parts : { 1, 2, 3, 4, 7, 16 })
    {
      const std::vector<Extent> extents = partsOfGrid(grid, parts);
      ASSERT_EQ(extents.size(), static_cast<std::size_t>(parts));
      for (const Extent& extent : extents)
      {
        for (int axis = 0; axis < 3 && !extent.empty(); ++axis)
        {
          EXPECT_EQ(extent.min[axis] % 16, 0);
        }
      }
      EXPECT_EQ(pointsOf(extents), grid.pointCount());
    }
  }
}

} // namespace
} // namespace medial::test

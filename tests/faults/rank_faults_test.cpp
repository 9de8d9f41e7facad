#include "failing_allocations.h"

#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "medial/error.h"
#include "medial/ranks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <mutex>
#include <new>
#include <set>
#include <string>
#include <vector>

// Ranks where one of them has no memory: all of them end, with the same error.

namespace medial::test
{
namespace
{

constexpr int kRanks = 3;

/// How a rank has ended: what failed, and the axis where it is gathered.
struct Ending
{
  std::string error;
  std::vector<Point3> points;
};

MedialAxis axisOfRanks(Communicator& communicator, const SurfacePiece& piece, const Grid& grid,
  Topology topology)
{
  MedialAxisOptions options;
  options.topology = topology;
  options.field.execution.threads = 1;
  const std::vector<Extent> extents = partsByWork(communicator, piece, grid, options.field);
  NoField nothing;
  return gatherMedialAxis(communicator,
    computeMedialAxis(communicator, piece, grid, extents, nothing, options));
}

/// Runs all ranks. From their first step on allocations count, on whatever rank.
/// @param failing the one that fails; none for 0.
std::vector<Ending> run(const std::vector<SurfacePiece>& pieces, const Grid& grid,
  Topology topology, std::int64_t failing, std::int64_t* count = nullptr)
{
  std::vector<Ending> endings(kRanks);
  std::once_flag started;
  SimulatedRanks(kRanks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      // All threads are there then: starting one takes memory.
      communicator.exchange(std::vector<Communicator::Message>(kRanks));
      std::call_once(started, [&] { failAllocation(failing, Failing::Once); });
      try
      {
        endings[rank].points = axisOfRanks(communicator, pieces[rank], grid, topology).points;
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.code(), ErrorCode::OutOfMemory) << error.what();
        endings[rank].error = error.what();
      }
      catch (const std::bad_alloc&)
      {
        endings[rank].error = "only this rank knows of it";
      }
    });
  const std::int64_t allocations = stopFailing();
  if (count != nullptr)
  {
    *count = allocations;
  }
  return endings;
}

class RankFaults : public testing::TestWithParam<Topology>
{
};

TEST_P(RankFaults, OnOneRankAreKnownToAll)
{
  const TriangleMesh mesh = numbered(lPrism(1.0, 0.5));
  const Grid grid = makeGrid(mesh.bounds(), 20);
  std::vector<SurfacePiece> pieces;
  for (int rank = 0; rank < kRanks; ++rank)
  {
    pieces.push_back(pieceOf(mesh, rank, atRandom(kRanks)));
  }
  run(pieces, grid, GetParam(), 0); // caches
  std::int64_t count = 0;
  const std::vector<Ending> expected = run(pieces, grid, GetParam(), 0, &count);
  ASSERT_FALSE(expected.front().points.empty());
  std::set<char> failed; // ranks
  for (std::int64_t n = 1; n <= count; n += stepBetweenFailures())
  {
    SCOPED_TRACE("allocation " + std::to_string(n) + " of " + std::to_string(count));
    const std::vector<Ending> endings = run(pieces, grid, GetParam(), n);
    const std::string& error = endings.front().error;
    for (const Ending& ending : endings)
    {
      ASSERT_EQ(ending.error, error);
    }
    if (error.empty()) // there was another way
    {
      EXPECT_EQ(endings.front().points, expected.front().points);
      continue;
    }
    EXPECT_EQ(error.rfind("rank ", 0), 0U) << error;
    failed.insert(error[5]);
  }
  EXPECT_EQ(failed, (std::set<char>{ '0', '1', '2' }));
}

INSTANTIATE_TEST_SUITE_P(Topologies, RankFaults,
  testing::Values(Topology::Selected, Topology::Preserve));

} // namespace
} // namespace medial::test

#include "failing_allocations.h"

#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "medial/error.h"
#include "medial/ranks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <new>
#include <ostream>
#include <set>
#include <string>
#include <vector>

// Ranks where one of them has no memory: all of them end, with the same error.

namespace medial::test
{
namespace
{

constexpr int kRanks = 3;

/// How a rank has ended: what failed, or what it has found.
struct Ending
{
  std::string error;
  std::vector<Point3> points; ///< or values in their first coordinates
};

/// What ranks do together.
struct Work
{
  const char* name;
  std::function<std::vector<Point3>(Communicator&, const SurfacePiece&, const Grid&)> run;
};

std::ostream& operator<<(std::ostream& stream, const Work& work)
{
  return stream << work.name;
}

/// The points of an axis, on the first rank.
Work axis(const char* name, Topology topology)
{
  return { name,
    [topology](Communicator& communicator, const SurfacePiece& piece, const Grid& grid)
    {
      MedialAxisOptions options;
      options.topology = topology;
      options.field.execution.threads = 1;
      const std::vector<Extent> extents = partsByWork(communicator, piece, grid, options.field);
      NoField nothing;
      return gatherMedialAxis(communicator,
        computeMedialAxis(communicator, piece, grid, extents, nothing, options))
        .points;
    } };
}

/// Where a solid is too thick, once its surface has been measured.
Work regions()
{
  return { "Regions",
    [](Communicator& communicator, const SurfacePiece& piece, const Grid&)
    {
      EXPECT_TRUE(measureSurface(communicator, piece).manifold);
      requireInside(communicator, piece, { 1, nullptr });
      ThicknessOptions options;
      options.cells = true;
      options.method = ThicknessMethod::Ray;
      options.execution.threads = 1;
      const Thickness thickness = computeThickness(communicator, piece, options);
      ThicknessLimits limits;
      limits.max = 1e-3;
      std::vector<Point3> places;
      for (const ThicknessRegion& region :
        findThicknessRegions(communicator, piece, thickness, limits))
      {
        places.push_back(region.place);
      }
      return places;
    } };
}

/// The distances in a rank's part of the grid from balls at the corners of triangles, and from what
/// lies between them.
Work reconstruction()
{
  return { "Reconstruction",
    [](Communicator& communicator, const SurfacePiece& piece, const Grid& grid)
    {
      std::vector<Point3> distances;
      agree(communicator,
        [&]
        {
          MedialModel model;
          model.centres = piece.mesh.points;
          model.radii.assign(model.centres.size(), 0.1);
          for (const auto& [a, b, c] : piece.mesh.triangles)
          {
            model.triangles.push_back({ a, b, c });
          }
          modelBounds(communicator, model);
          ReconstructionOptions options;
          options.execution.threads = 1;
          const Extent extent = partsOfGrid(grid, kRanks)[communicator.rank()];
          for (const float distance :
            computeReconstruction(communicator, model, grid, extent, options))
          {
            distances.push_back({ distance, 0.0, 0.0 });
          }
        });
      return distances;
    } };
}

/// Runs all ranks. From their first step on allocations count, on whatever rank.
/// @param failing the one that fails; none for 0.
std::vector<Ending> run(const std::vector<SurfacePiece>& pieces, const Grid& grid, const Work& work,
  std::int64_t failing, std::int64_t* count = nullptr)
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
        endings[rank].points = work.run(communicator, pieces[rank], grid);
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

class RankFaults : public testing::TestWithParam<Work>
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
  for (std::int64_t n = 1; n <= count; n += stepBetweenFailures(count))
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

INSTANTIATE_TEST_SUITE_P(Works, RankFaults,
  testing::Values(axis("Selected", Topology::Selected), axis("Preserve", Topology::Preserve),
    regions(), reconstruction()),
  testing::PrintToStringParamName());

} // namespace
} // namespace medial::test

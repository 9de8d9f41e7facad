#include "ranks/surface/shared_orientation.h"
#include "sign/surface_orientation.h"

#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

using Rim = std::vector<std::tuple<int, int, int>>;

template <typename Edges, typename EdgeOf>
Rim rimOf(const Edges& edges, const EdgeOf& edgeOf)
{
  Rim rim;
  for (const auto& item : edges)
  {
    const RimEdge& edge = edgeOf(item);
    rim.emplace_back(edge.from, edge.to, edge.weight);
  }
  return rim;
}

/// Expects ranks to decide how triangles count as one process does.
void expectSame(const TriangleMesh& mesh)
{
  const SurfaceOrientation whole = orientSurface(mesh, analyseConnectivity(mesh));
  const Rim rim = rimOf(whole.rim, [](const RimEdge& edge) { return edge; });
  for (const int ranks : { 1, 2, 3, 4, 7, 16 })
  {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    std::vector<int> different(ranks, 0);
    SimulatedRanks(ranks).run(
      [&](Communicator& communicator)
      {
        const int rank = communicator.rank();
        const DistributedSurface surface(communicator, pieceOf(mesh, rank, atRandom(ranks)));
        const SharedOrientation orientation(communicator, surface);
        for (std::size_t i = 0; i < surface.faces().size(); ++i)
        {
          different[rank] +=
            orientation.weights()[i] != whole.weights[surface.faces()[i].face] ? 1 : 0;
        }
        EXPECT_EQ(orientation.copies(), whole.copies);
        EXPECT_EQ(orientation.turned(), whole.turned);
        EXPECT_EQ(orientation.rimEdges(), static_cast<std::int64_t>(rim.size()));
        // In the same order: lids depend on it.
        EXPECT_EQ(rimOf(orientation.wholeRim(communicator),
                    [](const SharedRimEdge& edge) { return edge.rim; }),
          rim);
      });
    EXPECT_EQ(different, std::vector<int>(ranks, 0));
  }
}

} // namespace

TEST(SharedOrientation, OfDamagedSolidsIsThatOfOneProcess)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    SCOPED_TRACE(seed);
    const TriangleMesh mesh = damagedSolids(seed);
    const SurfaceOrientation whole = orientSurface(mesh, analyseConnectivity(mesh));
    ASSERT_GT(whole.copies, 0);
    ASSERT_GT(whole.turned, 0);
    ASSERT_GT(whole.rim.size(), 0U);
    expectSame(mesh);
  }
}

TEST(SharedOrientation, OfSolidsInSolidsIsThatOfOneProcess)
{
  // A ball inside out with cavities, and balls in these.
  TriangleMesh mesh;
  for (const double radius : { 0.3, 1.0, 0.2, 0.7 })
  {
    mesh = appended(mesh, flipOrientation(icosphere(radius, 2)));
    mesh = appended(mesh, translated(icosphere(radius, 1), { 3.0, 0.0, 0.0 }));
  }
  expectSame(numbered(mesh));
}

TEST(SharedOrientation, OfStripsWithATwistIsThatOfOneProcess)
{
  expectSame(moebiusStrips());
}

TEST(SharedOrientation, OfSingleTrianglesIsThatOfOneProcess)
{
  expectSame(numbered(randomSoup(200, 4)));
}

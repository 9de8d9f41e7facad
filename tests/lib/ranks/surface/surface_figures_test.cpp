#include "lib/ranks/message_of_ranks.h"
#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/shapes.h"

#include "medial/error.h"
#include "medial/mesh_connectivity.h"
#include "medial/ranks.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

// Figures of surfaces in pieces, against those of one process.

using namespace medial;
using namespace medial::test;

namespace
{

void expectSame(const TriangleMesh& mesh)
{
  const MeshConnectivity whole = analyseConnectivity(mesh);
  for (const int ranks : { 1, 2, 3, 7 })
  {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    for (const Distribution& rankOf :
      { atRandom(ranks), onTheLast(ranks), inRows(ranks, mesh.triangles.size()) })
    {
      SimulatedRanks(ranks).run(
        [&](Communicator& communicator)
        {
          SurfacePiece piece = pieceOf(mesh, communicator.rank(), rankOf);
          piece.mesh.degenerateTriangles = communicator.rank() + 1;
          const SurfaceFigures found = measureSurface(communicator, piece);
          EXPECT_EQ(found.degenerateTriangles, ranks * (ranks + 1) / 2);
          EXPECT_EQ(found.triangles, static_cast<std::int64_t>(mesh.triangles.size()));
          EXPECT_EQ(found.points, static_cast<std::int64_t>(mesh.points.size()));
          EXPECT_EQ(found.components, whole.components);
          EXPECT_EQ(found.closed, whole.closed());
          EXPECT_EQ(found.manifold, whole.manifold());
        });
    }
  }
}

/// Makes a mesh of triangles around points on a plane and above it.
TriangleMesh triangles(const std::vector<std::array<int, 3>>& corners, int points)
{
  MeshInput input;
  for (int i = 0; i < points; ++i)
  {
    const double x = i;
    input.points.push_back({ x, 0.7 * x * x - x, 0.1 * x * x * x });
  }
  for (const auto& [a, b, c] : corners)
  {
    input.polygons.append({ a, b, c }, input.polygons.size());
  }
  return buildTriangleMesh(input);
}

} // namespace

TEST(SurfaceFigures, AreThoseOfOneProcess)
{
  expectSame(torusAndBox());
  expectSame(moebiusStrips());
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    SCOPED_TRACE(seed);
    expectSame(withoutLoosePoints(damagedSolids(seed)));
  }
}

TEST(SurfaceFigures, TellWhatIsManifold)
{
  // A fan; two that share a point; three triangles at an edge; two that turn against each other;
  // two tetrahedra that share a point, and one with an open fan at its tip.
  expectSame(triangles({ { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 } }, 5));
  expectSame(triangles({ { 0, 1, 2 }, { 0, 3, 4 } }, 5));
  expectSame(triangles({ { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, 5));
  expectSame(triangles({ { 0, 1, 2 }, { 0, 1, 3 } }, 4));
  const std::vector<std::array<int, 3>> tetrahedron = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 },
    { 0, 3, 2 } };
  std::vector<std::array<int, 3>> two = tetrahedron;
  two.insert(two.end(), { { 0, 5, 4 }, { 0, 4, 6 }, { 4, 5, 6 }, { 0, 6, 5 } });
  expectSame(triangles(two, 7));
  std::vector<std::array<int, 3>> tip = tetrahedron;
  tip.push_back({ 0, 4, 5 });
  expectSame(triangles(tip, 6));
}

TEST(SurfaceFigures, NeedTrianglesAlone)
{
  TriangleMesh loose = triangles({ { 0, 1, 2 } }, 3);
  loose.points.push_back({ 9.0, 9.0, 9.0 });
  loose.vertices = { static_cast<int>(loose.points.size()) - 1 };
  loose.vertexCells = { 1 };
  for (const TriangleMesh& mesh : { TriangleMesh{}, loose })
  {
    SimulatedRanks(3).run(
      [&](Communicator& communicator)
      {
        SurfacePiece piece;
        if (communicator.rank() == 1)
        {
          piece.mesh = mesh;
          piece.pointOrder.resize(mesh.points.size());
          std::iota(piece.pointOrder.begin(), piece.pointOrder.end(), std::int64_t{ 0 });
        }
        EXPECT_THROW(measureSurface(communicator, piece), Error);
      });
  }
}

TEST(SurfaceFigures, NameARankWithAPointThatHasTwoPositions)
{
  // Two triangles that share a point, whose number the last ranks have at different positions.
  const TriangleMesh mesh = triangles({ { 0, 1, 2 }, { 2, 3, 4 } }, 5);
  constexpr int kRanks = 5;
  const auto message = [&](std::int64_t first, bool weld, bool elsewhere)
  {
    return messageOfRanks(kRanks,
      [&](Communicator& communicator)
      {
        const int rank = communicator.rank();
        SurfacePiece piece =
          pieceOf(mesh, rank, [](std::size_t triangle) { return static_cast<int>(triangle) + 3; });
        piece.weld = weld;
        for (std::size_t i = 0; i < piece.pointOrder.size(); ++i)
        {
          piece.mesh.points[i][0] += rank == 4 && piece.pointOrder[i] == 2 ? 0.5 : 0.0;
          piece.pointOrder[i] += first;
        }
        if (rank == 1 && elsewhere)
        {
          // The position of the number, under a higher one: that is allowed.
          piece.mesh = triangles({ { 2, 1, 0 } }, 3);
          piece.mesh.triangleCells = { 2 };
          piece.pointOrder = { first + 10, first + 11, first + 12 };
        }
        measureSurface(communicator, piece);
      });
  };
  for (std::int64_t first = 0; first < 40; ++first) // so that any rank collects the point
  {
    const std::string expected =
      "rank 3: point " + std::to_string(first + 2) + " has two positions";
    EXPECT_EQ(message(first, true, false), expected);
    EXPECT_EQ(message(first, false, false), expected);
    EXPECT_EQ(message(first, true, true), expected);
  }
}

TEST(SurfaceFigures, CountComponentsThatManyRanksHave)
{
  // A strip whose triangles go round the ranks, so that its lowest point is far away.
  std::vector<std::array<int, 3>> strip;
  constexpr int kLength = 60;
  for (int i = 0; i < kLength; ++i)
  {
    strip.push_back(
      i % 2 == 0 ? std::array<int, 3>{ i, i + 1, i + 2 } : std::array<int, 3>{ i + 1, i, i + 2 });
  }
  const TriangleMesh mesh = triangles(strip, kLength + 2);
  for (const bool together : { true, false })
  {
    constexpr int kRanks = 5;
    SimulatedRanks(kRanks).run(
      [&](Communicator& communicator)
      {
        const SurfaceFigures found = measureSurface(communicator,
          pieceOf(mesh, communicator.rank(),
            [&](std::size_t triangle)
            { return static_cast<int>(together ? triangle % kRanks : triangle / 12); }));
        EXPECT_EQ(found.components, 1);
        EXPECT_TRUE(found.manifold);
        EXPECT_FALSE(found.closed);
      });
  }
}

#include "medial/compute_distance_field.h"
#include "medial/ranks.h"

#include "field_of_ranks.h"
#include "lib/ranks/message_of_ranks.h"
#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/models.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

void expectSameBitsOfAllPartitions(const FieldCase& of)
{
  const DistanceField whole = wholeFieldOf(of);
  for (const int ranks : { 1, 2, 3, 4, 7, 16 })
  {
    const std::vector<Extent> extents = partsOfGrid(of.grid, ranks);
    expectSameBits(of, whole, extents, atRandom(ranks));
    expectSameBits(of, whole, extents, inRows(ranks, of.mesh.triangles.size()));
  }
  expectSameBits(of, whole, partsOfGrid(of.grid, 3), onTheLast(3));
}

} // namespace

TEST(DistributedField, OfATorusHasTheBitsOfOneProcess)
{
  const TriangleMesh mesh = torusAndBox();
  expectSameBitsOfAllPartitions({ mesh, gridAround(mesh, 70) });
}

TEST(DistributedField, OfASymmetricMeshHasTheBitsOfOneProcess)
{
  // Many ties: places of elements along every axis, and sites at equal distance.
  expectSameBitsOfAllPartitions({ numbered(shell(0.5, 1.0, 3)), symmetricGrid() });
}

TEST(DistributedField, OfTrianglesOfAllSizesHasTheBitsOfOneProcess)
{
  // Three trees by size, and tiles with hundreds of groups.
  const TriangleMesh mesh = numbered(appended(box({ 1.5, 1.4, 1.3 }),
    appended(translated(icosphere(0.2, 4), { 0.6, 0.5, 0.4 }),
      translated(icosphere(0.03, 4), { -0.6, 0.2, 0.3 }))));
  expectSameBitsOfAllPartitions({ mesh, gridAround(mesh, 40) });
}

TEST(DistributedField, OfAnOpenSurfaceHasTheBitsOfOneProcess)
{
  const TriangleMesh mesh = numbered(plates(0.3, 0.8));
  expectSameBitsOfAllPartitions({ mesh, gridAround(mesh, 37), SignMethod::None });
}

TEST(DistributedField, OfTrianglesWithoutAreaHasTheBitsOfOneProcess)
{
  const TriangleMesh mesh = numbered(hair(0.7, 5));
  expectSameBitsOfAllPartitions({ mesh, gridAround(mesh, 33), SignMethod::None });
}

TEST(DistributedField, OfAModelHasTheBitsOfOneProcess)
{
  const auto path = modelPath("paper/cow.off");
  const TriangleMesh mesh =
    path ? buildTriangleMesh(loadModel(*path)) : numbered(torus(0.8, 0.23, 90, 40));
  const FieldCase of{ mesh, gridAround(mesh, 90), SignMethod::None };
  const DistanceField whole = wholeFieldOf(of);
  expectSameBits(of, whole, partsOfGrid(of.grid, 5), atRandom(5));
}

TEST(DistributedField, HasTheBitsOfOneProcessInAnyExtents)
{
  const TriangleMesh mesh = numbered(torus(0.8, 0.23, 60, 30));
  const FieldCase of{ mesh, gridAround(mesh, 50) };
  const DistanceField whole = wholeFieldOf(of);
  const auto [x, y, z] = of.grid.wholeExtent().max;
  // They overlap, have ends within tiles, and one is empty.
  expectSameBits(of, whole,
    { { { 0, 0, 0 }, { x, y, 5 } }, { { 3, 2, 1 }, { 19, y, z } }, {},
      { { 11, 11, 2 }, { x, 17, 9 } } },
    atRandom(4));
}

TEST(DistributedField, NoRankHoldsTheWholeSurface)
{
  const TriangleMesh mesh = numbered(uvCapsule(0.3, 3.0, 160));
  const FieldCase of{ mesh, gridAround(mesh, 256) };
  const DistanceField whole = wholeFieldOf(of);
  const auto triangles = static_cast<std::int64_t>(mesh.triangles.size());
  for (const RankCounts& counts : expectSameBits(of, whole, partsOfGrid(of.grid, 8), atRandom(8)))
  {
    EXPECT_LT(counts.ownTriangles, triangles / 6);
    EXPECT_LT(counts.heldTriangles, 3 * triangles / 5);
  }
}

TEST(DistributedField, PiecesInTheOrderOfRanksAreOneMesh)
{
  const TriangleMesh first = torus(0.8, 0.23, 30, 12);
  const TriangleMesh second = translated(box({ 0.21, 0.33, 0.17 }), { 0.07, -0.05, 0.53 });
  const TriangleMesh mesh = numbered(appended(first, second));
  const FieldCase of{ mesh, gridAround(mesh, 30) };
  const DistanceField whole = wholeFieldOf(of);
  const std::vector<Extent> extents = partsOfGrid(of.grid, 3);
  SimulatedRanks(3).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      TriangleMesh own = rank == 0 ? first : rank == 2 ? second : TriangleMesh{};
      for (std::size_t i = 0; i < own.points.size(); ++i)
      {
        own.pointOfInput.push_back(static_cast<int>(i));
      }
      const auto points = static_cast<std::int64_t>(own.points.size());
      const auto cells = static_cast<std::int64_t>(own.triangles.size());
      KeepingSink sink(extents[rank]);
      computeDistanceField(communicator,
        inRankOrder(communicator, numbered(std::move(own)), points, cells), of.grid, extents[rank],
        sink, optionsOf(of));
      EXPECT_EQ(differences(whole, extents[rank], sink.field), 0U) << rank;
    });
}

TEST(DistributedField, OfDamagedSolidsHasTheBitsOfOneProcess)
{
  for (const SignMethod sign : { SignMethod::Winding, SignMethod::Auto, SignMethod::None })
  {
    for (const unsigned seed : { 1U, 2U })
    {
      const TriangleMesh mesh = damagedSolids(seed);
      expectSameBitsOfAllPartitions({ mesh, gridAround(mesh, 50), sign });
    }
  }
}

TEST(DistributedField, OfLargeHolesHasTheBitsOfOneProcess)
{
  // Lids across the whole grid, and grid points on them.
  TriangleMesh mesh = torus(1.0, 0.4, 40, 20);
  mesh.triangles.resize(mesh.triangles.size() * 2 / 3);
  mesh.triangleCells.resize(mesh.triangles.size());
  mesh = appended(mesh, translated(box({ 0.2, 0.2, 0.2 }), { 0.0, 0.0, 0.1 }));
  mesh.triangles.resize(mesh.triangles.size() - 2);
  mesh = numbered(withoutLoosePoints(mesh));
  for (const SignMethod sign : { SignMethod::Winding, SignMethod::Auto })
  {
    expectSameBitsOfAllPartitions({ mesh, gridAround(mesh, 48), sign });
  }
}

TEST(DistributedField, OfSoupsHasTheBitsOfOneProcess)
{
  const TriangleMesh soup = numbered(randomSoup(300, 7));
  expectSameBitsOfAllPartitions({ soup, gridAround(soup, 24), SignMethod::Winding });
  const TriangleMesh torn = numbered(randomSoup(500, 8));
  const FieldCase of{ torn, gridAround(torn, 20), SignMethod::Auto };
  ASSERT_EQ(computeDistanceField(of.mesh, of.grid, optionsOf(of)).sign, SignMethod::None);
  expectSameBitsOfAllPartitions(of);
}

TEST(DistributedField, OfStripsWithATwistHasTheBitsOfOneProcess)
{
  const TriangleMesh mesh = moebiusStrips();
  expectSameBitsOfAllPartitions({ mesh, gridAround(mesh, 40), SignMethod::Winding });
}

TEST(DistributedField, RefusesPseudonormalsOfAnOpenSurfaceOnEveryRank)
{
  const TriangleMesh open = numbered(plates(0.3, 0.8));
  const FieldCase of{ open, gridAround(open, 20) };
  const std::vector<Extent> extents = partsOfGrid(of.grid, 2);
  EXPECT_EQ(messageOfRanks(2,
              [&](Communicator& communicator)
              {
                const int rank = communicator.rank();
                NoField sink;
                computeDistanceField(communicator, pieceOf(of.mesh, rank, atRandom(2)), of.grid,
                  extents[rank], sink, optionsOf(of));
              }),
    "sign method pseudonormal needs a closed, consistently oriented mesh; this one has 8 boundary, "
    "0 non-manifold and 0 misoriented edges; use auto, winding or none");
}

TEST(DistributedField, RefusesSegments)
{
  TriangleMesh mesh = numbered(regularTetrahedron(1.0));
  mesh.segments = { { 0, 1 } };
  mesh.segmentCells = { 4 };
  const FieldCase of{ mesh, gridAround(mesh, 20) };
  SurfacePiece piece{ mesh, { 0, 1, 2, 3 } };
  const auto compute = [&](Communicator& communicator)
  {
    NoField sink;
    computeDistanceField(communicator, piece, of.grid, of.grid.wholeExtent(), sink, optionsOf(of));
  };
  // One along an edge of a triangle adds nothing.
  EXPECT_EQ(messageOfRanks(1, compute), "");
  piece.mesh.points.push_back({ 0.1, 0.2, 0.3 });
  piece.pointOrder.push_back(4);
  piece.mesh.segments = { { 0, 4 } };
  piece.mesh.vertices = { 4 };
  piece.mesh.vertexCells = { 5 };
  EXPECT_EQ(messageOfRanks(1, compute),
    "a surface in pieces must consist of triangles; this one has 1 line segment and 1 point of no "
    "triangle: it needs a single process");
}

TEST(DistributedField, RefusesPiecesThatOverlap)
{
  const TriangleMesh mesh = numbered(icosphere(1.0, 1));
  const FieldCase of{ mesh, gridAround(mesh, 20) };
  EXPECT_EQ(messageOfRanks(2,
              [&](Communicator& communicator)
              {
                NoField sink;
                computeDistanceField(communicator, pieceOf(of.mesh, 0, onTheLast(1)), of.grid,
                  of.grid.wholeExtent(), sink, optionsOf(of));
              }),
    "rank 0: the pieces overlap: cell 0 is in those of ranks 0 and 1");
}

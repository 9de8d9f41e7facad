#include "medial/compute_distance_field.h"
#include "medial/error.h"
#include "medial/ranks.h"

#include "pieces.h"
#include "simulated_ranks.h"
#include "support/models.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <tuple>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

bool sameBits(const void* a, const void* b, std::size_t bytes)
{
  return std::memcmp(a, b, bytes) == 0;
}

/// The arrays of a field of some extent, which it keeps together.
class KeepingSink : public FieldSink
{
public:
  explicit KeepingSink(const Extent& extent)
    : extent_(extent)
  {
    const auto count = static_cast<std::size_t>(extent.pointCount());
    field.distance.resize(count);
    field.closestPoint.resize(3 * count);
    field.closestSite.resize(count);
    field.closestFeature.resize(count);
    field.closestCell.resize(count);
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    const std::ptrdiff_t first =
      static_cast<std::ptrdiff_t>(slab.min[2] - extent_.min[2]) * extent_.size(0) * extent_.size(1);
    return { field.distance.data() + first, field.closestPoint.data() + 3 * first,
      field.closestSite.data() + first, field.closestFeature.data() + first,
      field.closestCell.data() + first };
  }
  void stored(const Extent& /*slab*/) override {}
  std::size_t bytesPerPoint() const override { return 0; }

  DistanceField field;

private:
  Extent extent_;
};

/// Number of grid points of an extent whose values differ from those of the whole field.
std::size_t differences(const DistanceField& whole, const Extent& extent, const DistanceField& part)
{
  std::size_t count = 0;
  std::size_t i = 0;
  for (int z = extent.min[2]; z <= extent.max[2]; ++z)
  {
    for (int y = extent.min[1]; y <= extent.max[1]; ++y)
    {
      for (int x = extent.min[0]; x <= extent.max[0]; ++x, ++i)
      {
        const std::size_t at = x +
          static_cast<std::size_t>(whole.grid.dimensions[0]) *
            (y + static_cast<std::size_t>(whole.grid.dimensions[1]) * z);
        const bool same = sameBits(&part.distance[i], &whole.distance[at], sizeof(float)) &&
          sameBits(&part.closestPoint[3 * i], &whole.closestPoint[3 * at], 3 * sizeof(float)) &&
          part.closestSite[i] == whole.closestSite[at] &&
          part.closestFeature[i] == whole.closestFeature[at] &&
          part.closestCell[i] == whole.closestCell[at];
        count += same ? 0 : 1;
      }
    }
  }
  return count;
}

/// What is computed by ranks and compared with one process.
struct Case
{
  TriangleMesh mesh;
  Grid grid;
  SignMethod sign = SignMethod::Pseudonormal;
};

DistanceFieldOptions optionsOf(const Case& of)
{
  DistanceFieldOptions options;
  options.sign = of.sign;
  options.engine = Engine::Processor;
  options.execution.threads = 1;
  return options;
}

bool sameReports(const SignReport& a, const SignReport& b)
{
  return std::tie(a.method, a.reason, a.rimEdges, a.holes, a.copies, a.turned, a.ambiguousShare,
           a.lidShare) ==
    std::tie(b.method, b.reason, b.rimEdges, b.holes, b.copies, b.turned, b.ambiguousShare,
      b.lidShare);
}

/// Expects the field of ranks to be that of one process, and returns what the ranks have held.
std::vector<RankCounts> expectSameBits(const Case& of, const DistanceField& whole,
  const std::vector<Extent>& extents, const Distribution& rankOf)
{
  const auto ranks = static_cast<int>(extents.size());
  std::vector<std::size_t> different(extents.size());
  std::vector<RankCounts> counts(extents.size());
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      KeepingSink sink(extents[rank]);
      const RunStatistics statistics = computeDistanceField(communicator,
        pieceOf(of.mesh, rank, rankOf), of.grid, extents[rank], sink, optionsOf(of), &counts[rank]);
      different[rank] = differences(whole, extents[rank], sink.field);
      EXPECT_TRUE(sameReports(statistics.sign, whole.statistics.sign)) << statistics.sign.reason;
    });
  for (int rank = 0; rank < ranks; ++rank)
  {
    EXPECT_EQ(different[rank], 0U) << "rank " << rank << " of " << ranks;
  }
  return counts;
}

void expectSameBitsOfAllPartitions(const Case& of)
{
  const DistanceField whole = computeDistanceField(of.mesh, of.grid, optionsOf(of));
  for (const int ranks : { 1, 2, 3, 4, 7, 16 })
  {
    const std::vector<Extent> extents = partsOfGrid(of.grid, ranks);
    expectSameBits(of, whole, extents, atRandom(ranks));
    expectSameBits(of, whole, extents, inRows(ranks, of.mesh.triangles.size()));
  }
  expectSameBits(of, whole, partsOfGrid(of.grid, 3), onTheLast(3));
}

/// The message that every rank must fail with.
std::string refusal(const TriangleMesh& mesh, int ranks, const Distribution& rankOf,
  SignMethod sign = SignMethod::None)
{
  const Grid grid = gridAround(mesh, 20);
  const std::vector<Extent> extents = partsOfGrid(grid, ranks);
  std::vector<std::string> messages(extents.size());
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      KeepingSink sink(extents[rank]);
      DistanceFieldOptions options;
      options.sign = sign;
      try
      {
        computeDistanceField(communicator, pieceOf(mesh, rank, rankOf), grid, extents[rank], sink,
          options);
      }
      catch (const Error& error)
      {
        messages[rank] = error.what();
      }
    });
  for (const std::string& message : messages)
  {
    EXPECT_EQ(message, messages.front());
  }
  return messages.front();
}

} // namespace

TEST(DistributedField, OfATorusHasTheBitsOfOneProcess)
{
  const TriangleMesh mesh =
    numbered(appended(translated(torus(0.8, 0.23, 60, 30), { 0.11, 0.03, -0.21 }),
      translated(box({ 0.21, 0.33, 0.17 }), { 0.07, -0.05, 0.53 })));
  expectSameBitsOfAllPartitions({ mesh, gridAround(mesh, 70) });
}

TEST(DistributedField, OfASymmetricMeshHasTheBitsOfOneProcess)
{
  // Many ties: places of elements along every axis, and sites at equal distance.
  const TriangleMesh mesh = numbered(shell(0.5, 1.0, 3));
  Grid grid = gridAround(mesh, 41);
  grid.origin = { -1.1, -1.1, -1.1 };
  grid.spacing = { 0.055, 0.055, 0.055 };
  expectSameBitsOfAllPartitions({ mesh, grid });
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
  const Case of{ mesh, gridAround(mesh, 90), SignMethod::None };
  const DistanceField whole = computeDistanceField(of.mesh, of.grid, optionsOf(of));
  expectSameBits(of, whole, partsOfGrid(of.grid, 5), atRandom(5));
}

TEST(DistributedField, HasTheBitsOfOneProcessInAnyExtents)
{
  const TriangleMesh mesh = numbered(torus(0.8, 0.23, 60, 30));
  const Case of{ mesh, gridAround(mesh, 50) };
  const DistanceField whole = computeDistanceField(of.mesh, of.grid, optionsOf(of));
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
  const Case of{ mesh, gridAround(mesh, 256) };
  const DistanceField whole = computeDistanceField(of.mesh, of.grid, optionsOf(of));
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
  const Case of{ mesh, gridAround(mesh, 30) };
  const DistanceField whole = computeDistanceField(of.mesh, of.grid, optionsOf(of));
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
  const Case of{ torn, gridAround(torn, 20), SignMethod::Auto };
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
  EXPECT_EQ(refusal(open, 2, atRandom(2), SignMethod::Pseudonormal),
    "sign method pseudonormal needs a closed, consistently oriented mesh; this one has 8 boundary, "
    "0 non-manifold and 0 misoriented edges; use auto, winding or none");
}

TEST(DistributedField, RefusesSegments)
{
  TriangleMesh mesh = numbered(regularTetrahedron(1.0));
  mesh.segments = { { 0, 1 } };
  mesh.segmentCells = { 4 };
  const Grid grid = gridAround(mesh, 20);
  SimulatedRanks(1).run(
    [&](Communicator& communicator)
    {
      SurfacePiece piece{ mesh, { 0, 1, 2, 3 } };
      KeepingSink sink(grid.wholeExtent());
      const DistanceFieldOptions options = optionsOf({ mesh, grid });
      // One along an edge of a triangle adds nothing.
      computeDistanceField(communicator, piece, grid, grid.wholeExtent(), sink, options);
      piece.mesh.points.push_back({ 0.1, 0.2, 0.3 });
      piece.pointOrder.push_back(4);
      piece.mesh.segments = { { 0, 4 } };
      piece.mesh.vertices = { 4 };
      piece.mesh.vertexCells = { 5 };
      try
      {
        computeDistanceField(communicator, piece, grid, grid.wholeExtent(), sink, options);
        FAIL();
      }
      catch (const Error& error)
      {
        EXPECT_STREQ(error.what(),
          "a surface in pieces must consist of triangles; this one has 1 line segment and 1 "
          "point of no triangle: it needs a single process");
      }
    });
}

TEST(DistributedField, RefusesPiecesThatOverlap)
{
  const TriangleMesh mesh = numbered(icosphere(1.0, 1));
  const Grid grid = gridAround(mesh, 20);
  std::vector<std::string> messages(2);
  SimulatedRanks(2).run(
    [&](Communicator& communicator)
    {
      KeepingSink sink(grid.wholeExtent());
      try
      {
        computeDistanceField(communicator, pieceOf(mesh, 0, onTheLast(1)), grid, grid.wholeExtent(),
          sink, optionsOf({ mesh, grid }));
      }
      catch (const Error& error)
      {
        messages[communicator.rank()] = error.what();
      }
    });
  EXPECT_EQ(messages[0], "rank 0: the pieces overlap: cell 0 is in those of ranks 0 and 1");
  EXPECT_EQ(messages[1], messages[0]);
}

TEST(PartsByWork, TakeAboutTheSame)
{
  // All triangles are in a corner, where equal parts would leave one rank most of the work.
  const TriangleMesh mesh =
    numbered(appended(box({ 1.5, 1.4, 1.3 }), translated(icosphere(0.2, 5), { 0.9, 0.8, 0.7 })));
  const Case of{ mesh, gridAround(mesh, 130) };
  const DistanceField whole = computeDistanceField(of.mesh, of.grid, optionsOf(of));
  constexpr int kRanks = 6;
  const auto busiest = [&](const std::vector<Extent>& extents)
  {
    std::vector<double> work(kRanks);
    SimulatedRanks(kRanks).run(
      [&](Communicator& communicator)
      {
        const int rank = communicator.rank();
        NoField sink;
        const RunStatistics statistics = computeDistanceField(communicator,
          pieceOf(of.mesh, rank, atRandom(kRanks)), of.grid, extents[rank], sink, optionsOf(of));
        work[rank] = static_cast<double>(
          statistics.groupTests + statistics.candidatePairs + statistics.fragments);
      });
    return kRanks * *std::max_element(work.begin(), work.end()) /
      std::accumulate(work.begin(), work.end(), 0.0);
  };
  std::vector<std::vector<Extent>> extents(kRanks);
  SimulatedRanks(kRanks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      extents[rank] =
        partsByWork(communicator, pieceOf(of.mesh, rank, atRandom(kRanks)), of.grid, optionsOf(of));
    });
  for (const std::vector<Extent>& parts : extents)
  {
    ASSERT_EQ(parts.size(), static_cast<std::size_t>(kRanks));
    for (int rank = 0; rank < kRanks; ++rank)
    {
      EXPECT_EQ(parts[rank].min, extents[0][rank].min);
      EXPECT_EQ(parts[rank].max, extents[0][rank].max);
    }
  }
  // The grid has 17 tiles along an edge: there is little choice where to cut.
  EXPECT_LT(busiest(extents[0]), 0.75 * busiest(partsOfGrid(of.grid, kRanks)));
  expectSameBits(of, whole, extents[0], atRandom(kRanks));
}

TEST(PartsByWork, LookAtOneSideAlone)
{
  const TriangleMesh mesh = numbered(icosphere(1.0, 3));
  Case of{ mesh, gridAround(mesh, 60), SignMethod::Winding };
  of.grid.dimensions = { 160, 160, 160 }; // most of it is empty
  constexpr int kRanks = 4;
  const auto ranksInside = [&](Side side)
  {
    std::vector<Extent> extents;
    SimulatedRanks(kRanks).run(
      [&](Communicator& communicator)
      {
        const std::vector<Extent> parts = partsByWork(communicator,
          pieceOf(of.mesh, communicator.rank(), atRandom(kRanks)), of.grid, optionsOf(of), side);
        if (communicator.rank() == 0)
        {
          extents = parts;
        }
      });
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
  const Case of{ mesh, gridAround(mesh, 12) };
  std::vector<Extent> extents;
  SimulatedRanks(16).run(
    [&](Communicator& communicator)
    {
      const std::vector<Extent> parts = partsByWork(communicator,
        pieceOf(of.mesh, communicator.rank(), atRandom(16)), of.grid, optionsOf(of));
      if (communicator.rank() == 0)
      {
        extents = parts;
      }
    });
  expectSameBits(of, computeDistanceField(of.mesh, of.grid, optionsOf(of)), extents, atRandom(16));
  std::int64_t points = 0;
  for (const Extent& extent : extents)
  {
    points += extent.empty() ? 0 : extent.pointCount();
  }
  EXPECT_EQ(points, of.grid.pointCount());
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
      std::int64_t points = 0;
      for (const Extent& extent : extents)
      {
        points += extent.pointCount();
        for (int axis = 0; axis < 3 && !extent.empty(); ++axis)
        {
          EXPECT_EQ(extent.min[axis] % 16, 0);
        }
      }
      EXPECT_EQ(points, grid.pointCount());
    }
  }
}

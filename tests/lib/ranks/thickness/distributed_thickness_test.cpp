#include "medial/mesh_connectivity.h"
#include "medial/ranks.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"

#include "lib/ranks/message_of_ranks.h"
#include "lib/ranks/pieces.h"
#include "lib/ranks/same_bits.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/errors.h"
#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

bool same(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// Number of places of a piece whose values differ from those of the whole.
std::size_t differences(const Thickness& whole, const SurfacePiece& piece, const Thickness& part,
  bool cells)
{
  EXPECT_EQ(part.values.size(), piece.mesh.points.size());
  EXPECT_EQ(part.triangleValues.size(), cells ? piece.mesh.triangles.size() : 0U);
  EXPECT_EQ(part.atEdge.size(), cells ? piece.mesh.points.size() : 0U);
  std::size_t count = 0;
  for (std::size_t i = 0; i < part.values.size(); ++i)
  {
    const std::int64_t number = piece.pointOrder[i];
    count += !sameBits(part.values[i], whole.values[number]) ||
        (cells && part.atEdge[i] != whole.atEdge[number])
      ? 1
      : 0;
  }
  for (std::size_t i = 0; i < part.triangleValues.size(); ++i)
  {
    const std::int64_t number = piece.mesh.triangleCells[i];
    count += !sameBits(part.triangleValues[i], whole.triangleValues[number]) ||
        part.triangleAtEdge[i] != whole.triangleAtEdge[number]
      ? 1
      : 0;
  }
  return count;
}

/// Expects the thickness of ranks to be that of one process, and returns what the ranks have held.
std::vector<RankCounts> expectSameBits(const TriangleMesh& mesh, const ThicknessOptions& options,
  const Thickness& whole, int ranks, const Distribution& rankOf)
{
  std::vector<std::size_t> different(static_cast<std::size_t>(ranks));
  std::vector<RankCounts> counts(different.size());
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      const SurfacePiece piece = pieceOf(mesh, rank, rankOf);
      const Thickness part = computeThickness(communicator, piece, options, &counts[rank]);
      different[rank] = differences(whole, piece, part, options.cells);
      EXPECT_TRUE(same(part.min, whole.min)) << part.min << " " << whole.min;
      EXPECT_TRUE(same(part.percentile5, whole.percentile5));
      EXPECT_TRUE(same(part.percentile95, whole.percentile95));
      EXPECT_TRUE(same(part.median, whole.median)) << part.median << " " << whole.median;
      EXPECT_TRUE(same(part.max, whole.max)) << part.max << " " << whole.max;
      EXPECT_EQ(part.points, whole.points);
      EXPECT_EQ(part.without, whole.without);
    });
  for (int rank = 0; rank < ranks; ++rank)
  {
    EXPECT_EQ(different[rank], 0U) << "rank " << rank << " of " << ranks;
  }
  return counts;
}

ThicknessOptions optionsOf(ThicknessMethod method, bool cells, double angle = kDefaultAngle,
  Side side = Side::Interior)
{
  ThicknessOptions options;
  options.method = method;
  options.cells = cells;
  options.angle = angle;
  options.side = side;
  options.execution.threads = 1;
  return options;
}

void expectSameBitsOfAllPartitions(const TriangleMesh& mesh, const ThicknessOptions& options)
{
  const Thickness whole = computeThickness(mesh, options);
  for (const int ranks : { 1, 2, 3, 4, 7, 16 })
  {
    expectSameBits(mesh, options, whole, ranks, atRandom(ranks));
  }
  expectSameBits(mesh, options, whole, 4, inRows(4, mesh.triangles.size()));
  expectSameBits(mesh, options, whole, 3, onTheLast(3));
}

void expectSameBitsByAllMethods(const TriangleMesh& mesh)
{
  for (const ThicknessOptions& options : { optionsOf(ThicknessMethod::Ball, false),
         optionsOf(ThicknessMethod::Ball, true, 100.0), optionsOf(ThicknessMethod::Ray, true),
         optionsOf(ThicknessMethod::Wall, true, kDefaultAngle, Side::Both) })
  {
    SCOPED_TRACE(testing::Message()
      << "method " << static_cast<int>(options.method) << ", angle " << options.angle);
    expectSameBitsOfAllPartitions(mesh, options);
  }
}

/// A base with a rib on it, its triangles divided, moved off the origin.
TriangleMesh ribOnBase(double maxEdge)
{
  const TriangleMesh coarse = appended(translated(box({ 3.0, 4.0, 1.0 }), { 0.31, 0.02, 0.13 }),
    translated(box({ 0.3, 4.1, 1.5 }), { 0.2, 0.0, 2.2 }));
  return numbered(subdivide(coarse, maxEdge).mesh);
}

std::string refusal(const TriangleMesh& mesh, const ThicknessOptions& options)
{
  constexpr int kRanks = 3;
  return messageOfRanks(kRanks,
    [&](Communicator& communicator) {
      computeThickness(communicator, pieceOf(mesh, communicator.rank(), atRandom(kRanks)), options);
    });
}

} // namespace

TEST(DistributedThickness, OfASmoothSolidHasTheBitsOfOneProcess)
{
  expectSameBitsByAllMethods(
    numbered(appended(translated(torus(0.8, 0.23, 30, 15), { 0.11, 0.03, -0.21 }),
      translated(box({ 0.21, 0.33, 0.17 }), { 0.07, -0.05, 0.53 }))));
}

TEST(DistributedThickness, OfWallsHasTheBitsOfOneProcess)
{
  expectSameBitsByAllMethods(ribOnBase(1.2));
}

// All facets of the inner sphere are equally near the middle, and many places tie.
TEST(DistributedThickness, OfASymmetricMeshHasTheBitsOfOneProcess)
{
  expectSameBitsByAllMethods(numbered(shell(0.5, 1.0, 2)));
}

// Orientation has to be found, and copies and fins stop rays.
TEST(DistributedThickness, OfDamagedSolidsHasTheBitsOfOneProcess)
{
  expectSameBitsByAllMethods(damagedSolids(1));
}

TEST(DistributedThickness, OfMoebiusStripsHasTheBitsOfOneProcess)
{
  expectSameBitsByAllMethods(moebiusStrips());
}

// Bodies touch at new points, which have numbers of their own.
TEST(DistributedThickness, OfADividedMeshHasTheBitsOfOneProcess)
{
  const TriangleMesh mesh = numbered(subdivide(
    appended(box({ 1.0, 0.9, 0.8 }), translated(box({ 0.1, 0.7, 0.5 }), { 0.0, 0.0, 1.3 })), 0.4)
                                       .mesh);
  const ThicknessOptions options = optionsOf(ThicknessMethod::Wall, true);
  const Thickness whole = computeThickness(mesh, options);
  for (const int ranks : { 1, 3, 7 })
  {
    SimulatedRanks(ranks).run(
      [&](Communicator& communicator)
      {
        SurfacePiece piece = pieceOf(mesh, communicator.rank(), atRandom(ranks));
        piece.weld = false;
        const Thickness part = computeThickness(communicator, piece, options);
        EXPECT_EQ(part.points, whole.points);
        EXPECT_EQ(differences(whole, piece, part, true), 0U);
      });
  }
}

TEST(DistributedThickness, DoesNotDependOnThreads)
{
  const TriangleMesh mesh = ribOnBase(0.6);
  ThicknessOptions options = optionsOf(ThicknessMethod::Wall, true);
  const Thickness whole = computeThickness(mesh, options);
  options.execution.threads = 3;
  expectSameBits(mesh, options, whole, 4, atRandom(4));
}

TEST(DistributedThickness, OfAModelHasTheBitsOfOneProcess)
{
  const std::optional<std::string> path = modelPath("cad/anchor_1k.off");
  const TriangleMesh mesh = path ? numbered(buildTriangleMesh(loadModel(*path))) : ribOnBase(0.3);
  for (const ThicknessOptions& options :
    { optionsOf(ThicknessMethod::Ball, true), optionsOf(ThicknessMethod::Wall, true, 150.0),
      optionsOf(ThicknessMethod::Ray, true, kDefaultAngle, Side::Exterior) })
  {
    const Thickness whole = computeThickness(mesh, options);
    expectSameBits(mesh, options, whole, 5, atRandom(5));
    expectSameBits(mesh, options, whole, 4, inRows(4, mesh.triangles.size()));
  }
}

// Their triangles lie on several ranks, and their figures depend on the order of triangles.
TEST(DistributedThickness, RegionsAreThoseOfOneProcess)
{
  const TriangleMesh mesh = ribOnBase(0.7);
  const ThicknessOptions options = optionsOf(ThicknessMethod::Wall, true);
  const ThicknessLimits limits{ 1.0, 2.5 };
  const Thickness whole = computeThickness(mesh, options);
  const std::vector<ThicknessRegion> expected = findThicknessRegions(mesh, whole, limits);
  ASSERT_GE(expected.size(), 2U);
  for (const int ranks : { 1, 2, 3, 7 })
  {
    std::vector<std::vector<ThicknessRegion>> found(static_cast<std::size_t>(ranks));
    std::vector<SurfacePiece> pieces(found.size());
    SimulatedRanks(ranks).run(
      [&](Communicator& communicator)
      {
        const int rank = communicator.rank();
        pieces[rank] = pieceOf(mesh, rank, atRandom(ranks));
        const Thickness part = computeThickness(communicator, pieces[rank], options);
        found[rank] = findThicknessRegions(communicator, pieces[rank], part, limits);
      });
    std::vector<std::vector<std::int64_t>> triangles(expected.size());
    for (int rank = 0; rank < ranks; ++rank)
    {
      ASSERT_EQ(found[rank].size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        const ThicknessRegion& region = found[rank][i];
        EXPECT_EQ(region.thin, expected[i].thin);
        EXPECT_EQ(region.area, expected[i].area);
        EXPECT_EQ(region.value, expected[i].value);
        EXPECT_EQ(region.place, expected[i].place);
        EXPECT_EQ(region.cells.size(), region.triangles.size());
        for (const int triangle : region.triangles)
        {
          triangles[i].push_back(pieces[rank].mesh.triangleCells[triangle]);
        }
      }
    }
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      std::sort(triangles[i].begin(), triangles[i].end());
      EXPECT_EQ(triangles[i], expected[i].cells) << "region " << i;
    }
  }
}

// Closed, with small holes, and without an inside for several reasons.
TEST(DistributedThickness, AnInsideIsRequiredAsInOneProcess)
{
  std::set<bool> verdicts;
  for (const TriangleMesh& mesh :
    { numbered(box({ 1.0, 1.0, 1.0 })), numbered(openTube(0.1, 4.0, 32)),
      numbered(plates(0.1, 1.0)), damagedSolids(1), damagedSolids(2), moebiusStrips() })
  {
    const std::string expected = messageOf([&] { requireInside(mesh, analyseConnectivity(mesh)); });
    verdicts.insert(expected.empty());
    for (const int ranks : { 1, 2, 3, 7 })
    {
      EXPECT_EQ(
        messageOfRanks(ranks,
          [&](Communicator& communicator)
          { requireInside(communicator, pieceOf(mesh, communicator.rank(), atRandom(ranks))); }),
        expected);
    }
  }
  EXPECT_EQ(verdicts.size(), 2U);
}

// Of a large surface no rank has much more than its share.
TEST(DistributedThickness, NoRankHoldsTheWholeSurface)
{
  const TriangleMesh mesh = numbered(torus(0.8, 0.23, 120, 60));
  const ThicknessOptions options = optionsOf(ThicknessMethod::Ball, false);
  const Thickness whole = computeThickness(mesh, options);
  const auto triangles = static_cast<std::int64_t>(mesh.triangles.size());
  for (const RankCounts& rank : expectSameBits(mesh, options, whole, 8, atRandom(8)))
  {
    EXPECT_LT(rank.heldTriangles, triangles / 4);
    EXPECT_LT(rank.ownTriangles, triangles / 8 + 2);
    EXPECT_GT(rank.bytesSent, 0);
  }
}

TEST(DistributedThickness, RefusesWhatOneProcessRefuses)
{
  const TriangleMesh mesh = numbered(box({ 1.0, 1.0, 1.0 }));
  EXPECT_NE(refusal(mesh, optionsOf(ThicknessMethod::Ball, false, 180.0)).find("180"),
    std::string::npos);
  EXPECT_EQ(refusal({}, optionsOf(ThicknessMethod::Ball, false)), "the mesh has no triangles");
}

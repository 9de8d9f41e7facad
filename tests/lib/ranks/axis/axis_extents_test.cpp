#include "medial/compute_medial_axis.h"
#include "medial/ranks.h"

#include "axis_of_ranks.h"
#include "lib/ranks/message_of_ranks.h"
#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Which rank computes which part of an axis, and what becomes of the parts.

namespace medial::test
{
namespace
{

/// Splits an edge of triangles in its middle, on one side alone: triangles without area close the
/// slits.
TriangleMesh withSlits(TriangleMesh mesh)
{
  const std::size_t count = mesh.triangles.size();
  std::set<std::pair<int, int>> split;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto [a, b, c] = mesh.triangles[i];
    if (!split.insert(std::minmax(a, b)).second)
    {
      continue;
    }
    const int middle = static_cast<int>(mesh.points.size());
    mesh.points.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
    {
      mesh.points.back()[axis] = 0.5 * (mesh.points[a][axis] + mesh.points[b][axis]);
    }
    mesh.triangles[i] = { a, middle, c };
    mesh.triangles.push_back({ middle, b, c });
    mesh.triangles.push_back({ a, b, middle });
  }
  mesh.triangleCells.resize(mesh.triangles.size());
  return mesh;
}

TEST(AxisOfExtents, IsThatOfOneProcessInAnyExtents)
{
  const AxisCase of = caseOf(torusAndBox(), 50);
  const auto [x, y, z] = of.grid.wholeExtent().max;
  const MedialAxis whole = wholeAxisOf(of);
  // One is a single layer, one is empty.
  const std::vector<Extent> extents{ { { 0, 0, 0 }, { x, y, 20 } }, { { 0, 0, 21 }, { x, y, 21 } },
    {}, { { 0, 0, 22 }, { 17, y, z } }, { { 18, 0, 22 }, { x, y, z } } };
  expectWhole(whole, axisOfRanks(of, extents, atRandom(5), extents));
  // Those of the axis may lie elsewhere.
  const std::vector<Extent> others{ extents[3], extents[2], extents[4], extents[0], extents[1] };
  expectWhole(whole, axisOfRanks(of, extents, atRandom(5), others));
}

TEST(AxisOfExtents, OfCutsThroughTrianglesWithoutAreaIsThatOfOneProcess)
{
  // All coordinates are exact, and cuts lie where triangles do.
  const TriangleMesh mesh = numbered(withSlits(
    appended(box({ 1.0, 0.75, 0.5 }), translated(box({ 0.25, 0.5, 0.75 }), { 1.5, 0.0, 0.0 }))));
  AxisCase of{ mesh, {} };
  of.grid.dimensions = { 102, 56, 56 };
  of.grid.origin = { -1.1875, -0.875, -0.875 };
  of.grid.spacing = { 0.03125, 0.03125, 0.03125 };
  of.side = Side::Both;
  const auto [x, y, z] = of.grid.wholeExtent().max;
  const MedialAxis whole = wholeAxisOf(of);
  ASSERT_GT(whole.cellCount(), 0);
  const int middle = 28; // where y and z are 0
  const int end = 70;    // where x is 1, an end of the first box
  const std::vector<Extent> extents{ { { 0, 0, 0 }, { end, middle, z } },
    { { 0, middle + 1, 0 }, { end, y, z } }, { { end + 1, 0, 0 }, { x, y, middle - 1 } },
    { { end + 1, 0, middle }, { x, y, z } } };
  expectWhole(whole, axisOfRanks(of, extents, atRandom(4), extents));
}

TEST(AxisOfExtents, GathersOnTheFirstRank)
{
  const AxisCase of = caseOf(torusAndBox(), 40);
  const MedialAxis whole = wholeAxisOf(of);
  const std::vector<AxisPiece> pieces = axisOfRanks(of, partsOfGrid(of.grid, 3), atRandom(3));
  SimulatedRanks(3).run(
    [&](Communicator& communicator)
    {
      const MedialAxis axis = gatherMedialAxis(communicator, pieces[communicator.rank()]);
      if (communicator.rank() > 0)
      {
        EXPECT_TRUE(axis.points.empty());
        EXPECT_EQ(axis.cellCount(), 0);
        return;
      }
      EXPECT_EQ(axis.sign, whole.sign);
      EXPECT_EQ(axis.side, whole.side);
      EXPECT_EQ(cellsOf(axis), cellsOf(whole));
      ASSERT_EQ(axis.points.size(), whole.points.size());
      for (std::size_t p = 0; p < whole.points.size(); ++p)
      {
        EXPECT_EQ(attributes(axis, p), attributes(whole, p));
      }
    });
}

TEST(AxisOfExtents, IsSharedOutByCrossings)
{
  // Plates, which are nearly all sheet, beside a ball of many triangles, which has hardly any axis.
  TriangleMesh mesh = translated(icosphere(0.5, 3), { 3.0, 0.0, 0.0 });
  for (const double z : { -0.4, -0.1, 0.2 })
  {
    mesh = appended(mesh, translated(box({ 1.2, 0.6, 0.06 }), { 0.0, 0.0, z }));
  }
  const AxisCase of = caseOf(numbered(mesh), 260);
  constexpr int kRanks = 4;
  const std::vector<Extent> equal = partsOfGrid(of.grid, kRanks);
  // Of a rank in its part and the halo around.
  const auto most = [&](const std::vector<Extent>& axisExtents)
  {
    std::vector<RankCounts> counts;
    axisOfRanks(of, equal, atRandom(kRanks), axisExtents, &counts);
    std::int64_t crossings = 0;
    for (const RankCounts& rank : counts)
    {
      crossings = std::max(crossings, rank.crossings);
    }
    return static_cast<double>(crossings);
  };
  EXPECT_LT(most({}), 0.8 * most(equal));
}

TEST(AxisOfExtents, ALimitOfSpheresLeavesTheFirstRankTheAxisOfOneProcess)
{
  constexpr std::int64_t kSpheres = 40;
  const AxisCase of = caseOf(torusAndBox(), 40);
  for (const Topology topology : { Topology::Selected, Topology::Preserve })
  {
    MedialAxisOptions options = optionsOf(of);
    options.topology = topology;
    options.maxSpheres = kSpheres;
    const MedialAxis expected = computeMedialAxis(of.mesh, of.grid, options);
    ASSERT_EQ(expected.points.size(), static_cast<std::size_t>(kSpheres));
    SimulatedRanks(3).run(
      [&](Communicator& communicator)
      {
        NoField sink;
        const AxisPiece piece =
          computeMedialAxis(communicator, pieceOf(of.mesh, communicator.rank(), atRandom(3)),
            of.grid, partsOfGrid(of.grid, 3), sink, options);
        EXPECT_EQ(piece.points, kSpheres);
        EXPECT_EQ(piece.cells, expected.cellCount());
        if (communicator.rank() > 0)
        {
          EXPECT_EQ(piece.axis.points.size() + piece.globalCellIds.size(), 0U);
          return;
        }
        for (std::size_t p = 0; p < expected.points.size(); ++p)
        {
          EXPECT_EQ(attributes(piece.axis, p), attributes(expected, p)) << p;
        }
        EXPECT_EQ(cellsOf(piece.axis), cellsOf(expected));
        EXPECT_EQ(piece.axis.solid.has_value(), topology == Topology::Preserve);
        EXPECT_EQ(piece.axis.simplification.inputPoints, expected.simplification.inputPoints);
      });
  }
}

TEST(AxisOfExtents, RefusesWhatIsWrongOnEveryRank)
{
  const AxisCase of = caseOf(torusAndBox(), 20);
  const auto refusal = [&](const std::vector<Extent>& extents, const MedialAxisOptions& options)
  {
    return messageOfRanks(2,
      [&](Communicator& communicator)
      {
        NoField sink;
        computeMedialAxis(communicator, pieceOf(of.mesh, communicator.rank(), atRandom(2)), of.grid,
          extents, sink, options);
      });
  };
  const std::vector<Extent> halves = partsOfGrid(of.grid, 2);
  MedialAxisOptions options = optionsOf(of);
  options.maxSpheres = -1;
  EXPECT_NE(refusal(halves, options).find("-1"), std::string::npos);
  options = optionsOf(of);
  options.angle = 180.0;
  EXPECT_NE(refusal(halves, options).find("180"), std::string::npos);
  EXPECT_EQ(refusal({ halves[0], halves[0] }, optionsOf(of)),
    "the extents of ranks 0 and 1 overlap");
  EXPECT_NE(refusal({ halves[0], {} }, optionsOf(of)).find("points"), std::string::npos);
  EXPECT_EQ(refusal({ of.grid.wholeExtent() }, optionsOf(of)),
    "1 extents for 2 ranks; there must be one for each");
}

} // namespace
} // namespace medial::test

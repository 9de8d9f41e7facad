#include "medial/axis_curves.h"
#include "medial/cell_topology.h"
#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/ranks.h"
#include "ranks/distributed_axis.h"

#include "pieces.h"
#include "simulated_ranks.h"
#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// What is computed by ranks and compared with one process.
struct Case
{
  TriangleMesh mesh;
  Grid grid;
  SignMethod sign = SignMethod::Pseudonormal;
  double angle = kDefaultAngle;
  Representation representation = Representation::Surface;
  Side side = Side::Interior;
  double lambda = 0.0;
  double radius = 0.0;
};

MedialAxisOptions optionsOf(const Case& of)
{
  MedialAxisOptions options;
  options.angle = of.angle;
  options.lambda = of.lambda;
  options.radius = of.radius;
  options.side = of.side;
  options.representation = of.representation;
  options.field.sign = of.sign;
  options.field.engine = Engine::Processor;
  options.field.execution.threads = 1;
  return options;
}

/// All that is known of a point, to compare bits.
std::array<double, 13> attributes(const MedialAxis& axis, std::size_t p)
{
  std::array<double, 13> all{};
  for (int i = 0; i < 3; ++i)
  {
    all[i] = axis.points[p][i];
    all[3 + i] = axis.closestPointA[p][i];
    all[6 + i] = axis.closestPointB[p][i];
  }
  all[9] = axis.radius[p];
  all[10] = axis.separationAngle[p];
  all[11] = axis.lambda[p];
  all[12] = static_cast<double>(axis.feature[p]);
  return all;
}

using Cells = std::vector<std::vector<std::int64_t>>;

/// Returns all cells in the order of their numbers.
Cells cellsOf(const MedialAxis& axis)
{
  Cells cells;
  for (const std::int64_t vertex : axis.vertices)
  {
    cells.push_back({ vertex });
  }
  const auto add = [&](const auto& some)
  {
    for (const auto& cell : some)
    {
      cells.emplace_back(cell.begin(), cell.end());
    }
  };
  add(axis.lines);
  add(axis.quads);
  add(axis.triangles);
  return cells;
}

/// Expects pieces to be the axis of one process: each cell once, and points on cuts alike.
void expectWhole(const MedialAxis& whole, const std::vector<AxisPiece>& pieces)
{
  const Cells wholeCells = cellsOf(whole);
  std::vector<int> seen(wholeCells.size(), 0);
  std::size_t differentPoints = 0;
  std::size_t differentCells = 0;
  for (const AxisPiece& piece : pieces)
  {
    ASSERT_EQ(piece.points, static_cast<std::int64_t>(whole.points.size()));
    ASSERT_EQ(piece.cells, static_cast<std::int64_t>(wholeCells.size()));
    ASSERT_EQ(piece.globalPointIds.size(), piece.axis.points.size());
    for (std::size_t p = 0; p < piece.axis.points.size(); ++p)
    {
      const auto id = static_cast<std::size_t>(piece.globalPointIds[p]);
      differentPoints += attributes(piece.axis, p) == attributes(whole, id) ? 0 : 1;
    }
    Cells cells = cellsOf(piece.axis);
    ASSERT_EQ(piece.globalCellIds.size(), cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      for (std::int64_t& corner : cells[c])
      {
        corner = piece.globalPointIds[corner];
      }
      differentCells += cells[c] == wholeCells[piece.globalCellIds[c]] ? 0 : 1;
      ++seen[piece.globalCellIds[c]];
    }
  }
  EXPECT_EQ(differentPoints, 0U);
  EXPECT_EQ(differentCells, 0U);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
}

/// @param axisExtents where ranks make the axis; if empty they choose themselves.
std::vector<AxisPiece> axisOfRanks(const Case& of, const std::vector<Extent>& extents,
  const Distribution& rankOf, const std::vector<Extent>& axisExtents = {},
  std::vector<RankCounts>* counts = nullptr)
{
  const auto ranks = static_cast<int>(extents.size());
  std::vector<AxisPiece> pieces(extents.size());
  std::vector<RankCounts> ownCounts(extents.size());
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      NoField sink;
      pieces[rank] = computeMedialAxis(communicator, pieceOf(of.mesh, rank, rankOf), of.grid,
        extents, axisExtents, sink, optionsOf(of), &ownCounts[rank]);
    });
  if (counts != nullptr)
  {
    *counts = ownCounts;
  }
  return pieces;
}

void expectSameAxisOfAllPartitions(const Case& of)
{
  const MedialAxis whole = computeMedialAxis(of.mesh, of.grid, optionsOf(of));
  ASSERT_GT(whole.cellCount(), 0);
  for (const int ranks : { 1, 2, 3, 4, 7, 16 })
  {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    const std::vector<Extent> extents = partsOfGrid(of.grid, ranks);
    expectWhole(whole, axisOfRanks(of, extents, atRandom(ranks)));
    expectWhole(whole, axisOfRanks(of, extents, atRandom(ranks), extents));
  }
}

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

TriangleMesh torusAndBox()
{
  return numbered(appended(translated(torus(0.8, 0.23, 60, 30), { 0.11, 0.03, -0.21 }),
    translated(box({ 0.21, 0.33, 0.17 }), { 0.07, -0.05, 0.53 })));
}

} // namespace

TEST(DistributedAxis, OfATorusAndABoxIsThatOfOneProcess)
{
  const TriangleMesh mesh = torusAndBox();
  expectSameAxisOfAllPartitions({ mesh, gridAround(mesh, 70) });
}

TEST(DistributedAxis, OfBoxesIsThatOfOneProcess)
{
  // Sheets with seams and creases, in a grid that is not even.
  const TriangleMesh mesh = numbered(box({ 1.5, 1.1, 0.7 }));
  Grid grid = gridAround(mesh, 90);
  grid.spacing[1] *= 1.3;
  expectSameAxisOfAllPartitions({ mesh, grid });
}

TEST(DistributedAxis, OfBothSidesIsThatOfOneProcess)
{
  Case of{ torusAndBox(), {} };
  of.grid = gridAround(of.mesh, 61);
  of.side = Side::Both;
  of.angle = 25.0;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfASymmetricMeshIsThatOfOneProcess)
{
  // A round wall: sheets of facets, curves, and sites at equal distance.
  const TriangleMesh mesh = numbered(shell(0.5, 1.0, 3));
  Grid grid = gridAround(mesh, 41);
  grid.origin = { -1.1, -1.1, -1.1 };
  grid.spacing = { 0.055, 0.055, 0.055 };
  expectSameAxisOfAllPartitions({ mesh, grid });
}

TEST(DistributedAxis, OfAnOpenSurfaceIsThatOfOneProcess)
{
  const TriangleMesh mesh = numbered(plates(0.3, 0.8));
  expectSameAxisOfAllPartitions({ mesh, gridAround(mesh, 50), SignMethod::None });
}

TEST(DistributedAxis, OfDamagedSolidsIsThatOfOneProcess)
{
  for (const SignMethod sign : { SignMethod::Winding, SignMethod::Auto, SignMethod::None })
  {
    Case of{ damagedSolids(3), {}, sign };
    of.grid = gridAround(of.mesh, 44);
    of.side = Side::Both;
    expectSameAxisOfAllPartitions(of);
  }
}

TEST(DistributedAxis, OfSolidsWithLargeHolesIsThatOfOneProcess)
{
  // Two thin walls that do not face alike; one is open at an end.
  TriangleMesh mesh = appended(flipOrientation(box({ 0.8, 0.8, 0.06 })),
    translated(uvCapsule(0.3, 0.5, 16), { 0.0, 0.0, 1.0 }));
  mesh.triangles.resize(mesh.triangles.size() - 8);
  Case of{ numbered(withoutLoosePoints(mesh)), {}, SignMethod::Winding };
  of.grid = gridAround(of.mesh, 54);
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfPartsThatFaceDifferentWaysIsThatOfOneProcess)
{
  Case of{ numbered(appended(flipOrientation(icosphere(0.5, 2)),
             translated(box({ 0.21, 0.33, 0.17 }), { 0.9, -0.05, 0.13 }))),
    {} };
  of.grid = gridAround(of.mesh, 50);
  of.side = Side::Both;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, WithLimitsIsThatOfOneProcess)
{
  Case of{ torusAndBox(), {} };
  of.grid = gridAround(of.mesh, 60);
  of.lambda = 0.1;
  of.radius = 0.12;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfPointsIsThatOfOneProcess)
{
  Case of{ torusAndBox(), {} };
  of.grid = gridAround(of.mesh, 60);
  of.representation = Representation::Points;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfFacesIsThatOfOneProcess)
{
  Case of{ torusAndBox(), {} };
  of.grid = gridAround(of.mesh, 60);
  of.representation = Representation::Faces;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfThinPartsIsThatOfOneProcess)
{
  // Curves, most of whose points become one with others.
  const TriangleMesh mesh = numbered(uvCapsule(0.05, 1.0, 24));
  expectSameAxisOfAllPartitions({ mesh, gridAround(mesh, 130) });
}

TEST(DistributedAxis, OfSlicesOfThickSlabsIsThatOfOneProcess)
{
  // More slices than the thickest slab has, where the order of crossings changes.
  const TriangleMesh mesh = numbered(uvCapsule(0.3, 1.0, 24));
  Case of{ mesh, gridAround(mesh, 150) };
  ASSERT_GT(of.grid.dimensions[2], 128);
  const MedialAxis whole = computeMedialAxis(of.mesh, of.grid, optionsOf(of));
  expectWhole(whole, axisOfRanks(of, partsOfGrid(of.grid, 5), onTheLast(5)));
}

TEST(DistributedAxis, IsThatOfOneProcessInAnyExtents)
{
  Case of{ torusAndBox(), {} };
  of.grid = gridAround(of.mesh, 50);
  const auto [x, y, z] = of.grid.wholeExtent().max;
  const MedialAxis whole = computeMedialAxis(of.mesh, of.grid, optionsOf(of));
  // One is a single layer, one is empty.
  const std::vector<Extent> extents{ { { 0, 0, 0 }, { x, y, 20 } }, { { 0, 0, 21 }, { x, y, 21 } },
    {}, { { 0, 0, 22 }, { 17, y, z } }, { { 18, 0, 22 }, { x, y, z } } };
  expectWhole(whole, axisOfRanks(of, extents, atRandom(5), extents));
  // Those of the axis may lie elsewhere.
  const std::vector<Extent> others{ extents[3], extents[2], extents[4], extents[0], extents[1] };
  expectWhole(whole, axisOfRanks(of, extents, atRandom(5), others));
}

TEST(DistributedAxis, OfCutsThroughTrianglesWithoutAreaIsThatOfOneProcess)
{
  // All coordinates are exact, and cuts lie where triangles do.
  const TriangleMesh mesh = numbered(withSlits(
    appended(box({ 1.0, 0.75, 0.5 }), translated(box({ 0.25, 0.5, 0.75 }), { 1.5, 0.0, 0.0 }))));
  Case of{ mesh, {} };
  of.grid.dimensions = { 102, 56, 56 };
  of.grid.origin = { -1.1875, -0.875, -0.875 };
  of.grid.spacing = { 0.03125, 0.03125, 0.03125 };
  of.side = Side::Both;
  const auto [x, y, z] = of.grid.wholeExtent().max;
  const MedialAxis whole = computeMedialAxis(of.mesh, of.grid, optionsOf(of));
  ASSERT_GT(whole.cellCount(), 0);
  const int middle = 28; // where y and z are 0
  const int end = 70;    // where x is 1, an end of the first box
  const std::vector<Extent> extents{ { { 0, 0, 0 }, { end, middle, z } },
    { { 0, middle + 1, 0 }, { end, y, z } }, { { end + 1, 0, 0 }, { x, y, middle - 1 } },
    { { end + 1, 0, middle }, { x, y, z } } };
  expectWhole(whole, axisOfRanks(of, extents, atRandom(4), extents));
}

TEST(DistributedAxis, GathersOnTheFirstRank)
{
  Case of{ torusAndBox(), {} };
  of.grid = gridAround(of.mesh, 40);
  const MedialAxis whole = computeMedialAxis(of.mesh, of.grid, optionsOf(of));
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

TEST(DistributedAxis, IsSharedOutByCrossings)
{
  // Plates, which are nearly all sheet, beside a ball of many triangles, which has hardly any axis.
  TriangleMesh mesh = translated(icosphere(0.5, 3), { 3.0, 0.0, 0.0 });
  for (const double z : { -0.4, -0.1, 0.2 })
  {
    mesh = appended(mesh, translated(box({ 1.2, 0.6, 0.06 }), { 0.0, 0.0, z }));
  }
  Case of{ numbered(mesh), {} };
  of.grid = gridAround(of.mesh, 260);
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

class DistributedAxisOfModels : public testing::TestWithParam<std::string>
{
};

TEST_P(DistributedAxisOfModels, IsThatOfOneProcess)
{
  Case of{ numbered(buildTriangleMesh(loadModel(*modelPath(GetParam())))), {} };
  of.grid = gridAround(of.mesh, 64);
  for (const double angle : { 60.0, 20.0 })
  {
    SCOPED_TRACE(angle);
    of.angle = angle;
    const MedialAxis whole = computeMedialAxis(of.mesh, of.grid, optionsOf(of));
    expectWhole(whole, axisOfRanks(of, partsOfGrid(of.grid, 6), atRandom(6)));
  }
}

INSTANTIATE_TEST_SUITE_P(Models, DistributedAxisOfModels,
  testing::ValuesIn(
    []
    {
      std::vector<std::string> present;
      for (const char* name :
        { "paper/gargoyle_20k.off", "organic/fertility_genus4.off", "cad/fandisk_13k.obj" })
      {
        if (modelPath(name))
        {
          present.emplace_back(name);
        }
      }
      return present;
    }()));
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DistributedAxisOfModels);

TEST(DistributedAxis, RefusesWhatNeedsTheWholeOnEveryRank)
{
  Case of{ torusAndBox(), {} };
  of.grid = gridAround(of.mesh, 20);
  const auto refusal = [&](const std::vector<Extent>& extents, const MedialAxisOptions& options)
  {
    std::vector<std::string> messages(2);
    SimulatedRanks(2).run(
      [&](Communicator& communicator)
      {
        NoField sink;
        try
        {
          computeMedialAxis(communicator, pieceOf(of.mesh, communicator.rank(), atRandom(2)),
            of.grid, extents, sink, options);
        }
        catch (const Error& error)
        {
          messages[communicator.rank()] = error.what();
        }
      });
    EXPECT_EQ(messages[0], messages[1]);
    return messages[0];
  };
  const std::vector<Extent> halves = partsOfGrid(of.grid, 2);
  MedialAxisOptions options = optionsOf(of);
  options.topology = Topology::Preserve;
  EXPECT_EQ(refusal(halves, options), "preserved topology needs the whole axis in one process");
  options = optionsOf(of);
  options.maxSpheres = 10;
  EXPECT_EQ(refusal(halves, options),
    "a maximum number of spheres needs the whole axis in one process");
  options = optionsOf(of);
  options.angle = 180.0;
  EXPECT_NE(refusal(halves, options).find("180"), std::string::npos);
  EXPECT_EQ(refusal({ halves[0], halves[0] }, optionsOf(of)),
    "the extents of ranks 0 and 1 overlap");
  EXPECT_NE(refusal({ halves[0], {} }, optionsOf(of)).find("points"), std::string::npos);
  EXPECT_EQ(refusal({ of.grid.wholeExtent() }, optionsOf(of)),
    "1 extents for 2 ranks; there must be one for each");
}

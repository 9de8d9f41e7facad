#include "medial/axis_curves.h"
#include "medial/cell_topology.h"
#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/ranks.h"

#include "pieces.h"
#include "simulated_ranks.h"
#include "support/models.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Wants nothing.
class NoField : public FieldSink
{
public:
  FieldArrays slabArrays(const Extent& /*slab*/) override { return {}; }
  void stored(const Extent& /*slab*/) override {}
  std::size_t bytesPerPoint() const override { return 0; }
};

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

std::vector<AxisPiece> axisOfRanks(const Case& of, const std::vector<Extent>& extents,
  const Distribution& rankOf, std::vector<RankCounts>* counts = nullptr)
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
        extents, sink, optionsOf(of), &ownCounts[rank]);
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
  }
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

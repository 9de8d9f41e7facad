#include "axis_of_ranks.h"

#include "ranks/axis/distributed_axis.h"

#include "lib/ranks/simulated_ranks.h"

#include "support/models.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace medial::test
{

AxisCase caseOf(const TriangleMesh& mesh, int resolution)
{
  return { mesh, gridAround(mesh, resolution) };
}

std::vector<std::string> modelsForRanks()
{
  std::vector<std::string> present;
  for (const char* name : { "paper/gargoyle_20k.off", "organic/fertility_genus4.off",
         "cad/fandisk_13k.obj", "selfint/footbones_26comp_4.2k.off" })
  {
    if (modelPath(name))
    {
      present.emplace_back(name);
    }
  }
  return present;
}

MedialAxisOptions optionsOf(const AxisCase& of)
{
  MedialAxisOptions options;
  options.angle = of.angle;
  options.lambda = of.lambda;
  options.radius = of.radius;
  options.side = of.side;
  options.representation = of.representation;
  options.topology = of.topology;
  options.field.sign = of.sign;
  options.field.engine = Engine::Processor;
  options.field.execution.threads = 1;
  return options;
}

MedialAxis wholeAxisOf(const AxisCase& of)
{
  return computeMedialAxis(of.mesh, of.grid, optionsOf(of));
}

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

std::array<std::int64_t, 4> numbersOf(const CellTopology& topology)
{
  return { topology.components, topology.eulerCharacteristic, topology.genus, topology.cavities };
}

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
    ASSERT_EQ(piece.axis.solid.has_value(), whole.solid.has_value());
    if (whole.solid)
    {
      EXPECT_EQ(numbersOf(*piece.axis.solid), numbersOf(*whole.solid));
    }
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

std::vector<AxisPiece> axisOfRanks(const AxisCase& of, const std::vector<Extent>& extents,
  const Distribution& rankOf, const std::vector<Extent>& axisExtents,
  std::vector<RankCounts>* counts)
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

void expectSameAxisOfAllPartitions(const AxisCase& of)
{
  const MedialAxis whole = wholeAxisOf(of);
  ASSERT_GT(whole.cellCount(), 0);
  ASSERT_EQ(whole.solid.has_value(), of.topology == Topology::Preserve);
  if (whole.solid)
  {
    ASSERT_EQ(numbersOf(topologyOf(whole)), numbersOf(*whole.solid));
  }
  for (const int ranks : { 1, 2, 3, 4, 7, 16 })
  {
    SCOPED_TRACE(std::to_string(ranks) + " ranks");
    const std::vector<Extent> extents = partsOfGrid(of.grid, ranks);
    expectWhole(whole, axisOfRanks(of, extents, atRandom(ranks)));
    expectWhole(whole, axisOfRanks(of, extents, atRandom(ranks), extents));
  }
}

void expectSameAxisAtAngles(AxisCase of)
{
  for (const double angle : { 60.0, 20.0 })
  {
    SCOPED_TRACE(angle);
    of.angle = angle;
    const MedialAxis whole = wholeAxisOf(of);
    ASSERT_EQ(whole.solid.has_value(), of.topology == Topology::Preserve);
    expectWhole(whole, axisOfRanks(of, partsOfGrid(of.grid, 6), atRandom(6)));
  }
}

} // namespace medial::test

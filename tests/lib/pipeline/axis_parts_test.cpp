// An axis in parts against that of the whole grid at once.
#include "pipeline/axis_parts.h"

#include "medial/compute_medial_axis.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// The corners of a cell, in units of 1e-3 of the spacing, in ascending order.
using Cell = std::vector<std::array<std::int64_t, 4>>;

template <typename Ids>
Cell cellOf(const MedialAxis& axis, const Ids& ids, double spacing)
{
  const auto rounded = [&](double length)
  { return static_cast<std::int64_t>(std::llround(length / spacing * 1e3)); };
  Cell cell;
  for (const std::int64_t id : ids)
  {
    const Point3& p = axis.points[id];
    cell.push_back({ rounded(p[0]), rounded(p[1]), rounded(p[2]),
      rounded(static_cast<double>(axis.radius[id])) });
  }
  std::sort(cell.begin(), cell.end());
  return cell;
}

void addCells(const MedialAxis& axis, double spacing, std::set<Cell>& cells)
{
  for (const auto& quad : axis.quads)
  {
    cells.insert(cellOf(axis, quad, spacing));
  }
  for (const auto& triangle : axis.triangles)
  {
    cells.insert(cellOf(axis, triangle, spacing));
  }
  for (const auto& line : axis.lines)
  {
    cells.insert(cellOf(axis, line, spacing));
  }
}

/// A frame that stands, turned to be in no plane of the grid.
TriangleMesh frame()
{
  TriangleMesh mesh = blocks({ "#####", "#...#", "#####" }, 0.6);
  for (Point3& p : mesh.points)
  {
    p = { 0.8 * p[0] + 0.6 * p[2], p[1] + 0.1 * p[0], -0.6 * p[0] + 0.8 * p[2] };
  }
  return mesh;
}

std::set<Cell> cellsOfWhole(const TriangleMesh& mesh, const Grid& grid, Side side)
{
  MedialAxisOptions options;
  options.angle = 25.0;
  options.side = side;
  std::set<Cell> cells;
  addCells(computeMedialAxis(mesh, grid, options), grid.spacing[0], cells);
  return cells;
}

} // namespace

TEST(AxisParts, HaveTheCellsOfTheWholeOnBothSidesButFewAtBorders)
{
  const TriangleMesh mesh = frame();
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const Grid grid = makeGrid(mesh.bounds(), 72, 0.1);
  AxisPartsOptions options;
  options.angle = 25.0;
  options.side = Side::Both;
  options.crossings = 1;
  options.slices = 16;
  AxisParts parts(mesh, connectivity, grid, options, medial::Run(Execution{}));
  NoField sink;
  parts.computeField(sink);
  for (const Side side : { Side::Interior, Side::Exterior })
  {
    std::size_t count = 0;
    std::set<Cell> cells;
    parts.forParts(side, medial::Run(Execution{}),
      [&](const MedialAxis& axis, const BallMesh&)
      {
        EXPECT_EQ(axis.side, side);
        addCells(axis, grid.spacing[0], cells);
        ++count;
      });
    EXPECT_GE(count, 3u);
    const std::set<Cell> whole = cellsOfWhole(mesh, grid, side);
    EXPECT_GT(whole.size(), 1000u);
    std::vector<Cell> different;
    std::set_symmetric_difference(cells.begin(), cells.end(), whole.begin(), whole.end(),
      std::back_inserter(different));
    EXPECT_LT(different.size(), whole.size() / 200);
  }
}

TEST(AxisParts, OfAFewCrossingsAreOne)
{
  const TriangleMesh mesh = frame();
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  AxisParts parts(mesh, connectivity, makeGrid(mesh.bounds(), 200, 0.1), AxisPartsOptions{},
    medial::Run(Execution{}));
  NoField sink;
  parts.computeField(sink);
  int count = 0;
  parts.forParts(Side::Interior, medial::Run(Execution{}),
    [&](const MedialAxis&, const BallMesh&) { ++count; });
  EXPECT_EQ(count, 1);
}

// The cells along the seams of a box, which are known: where the three nearest walls are equally
// far away.
#include "axis/seams/seam_cells.h"

#include "axis/seams/cell_sides.h"
#include "support/medial_checks.h"
#include "support/mesh_crossings.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr std::array<double, 3> kHalf{ 0.9, 0.6, 0.4 };
constexpr double kSpacing = 0.031;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr double kExact = 5e-3; ///< voxels

/// Distances from the walls, ascending, voxels.
std::array<double, 6> wallDistances(const Point3& p)
{
  std::array<double, 6> walls{};
  for (int axis = 0; axis < 3; ++axis)
  {
    walls[2 * axis] = (kHalf[axis] - p[axis]) / kSpacing;
    walls[2 * axis + 1] = (kHalf[axis] + p[axis]) / kSpacing;
  }
  std::sort(walls.begin(), walls.end());
  return walls;
}

/// Points of a seam towards a corner, and of one between floor, ceiling and an end.
std::vector<Point3> pointsOfSeams()
{
  std::vector<Point3> points;
  for (double t = 0.1; t < 0.3; t += 0.3 * kSpacing)
  {
    points.push_back({ kHalf[0] - t, kHalf[1] - t, kHalf[2] - t });
    points.push_back({ kHalf[0] - kHalf[2], t - 0.2, 0.0 });
  }
  return points;
}

class SeamsOfABox : public testing::Test
{
protected:
  Point3 worldOf(const glm::dvec3& x) const { return box_.frame().toWorld(x); }
  /// The vertex of the cell at a point; kNone if it is none of the seams'.
  std::size_t vertexAt(const Point3& p) const
  {
    glm::ivec3 cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      cell[axis] = static_cast<int>(
        std::floor((p[axis] - box_.grid().origin[axis]) / box_.grid().spacing[axis]));
    }
    const auto found = std::find_if(cells_.vertices().begin(), cells_.vertices().end(),
      [&](std::uint32_t vertex) { return cells_.mesh().cells[vertex] == cell; });
    return found != cells_.vertices().end() ? *found : kNone;
  }
  CellSides sidesOf(std::size_t vertex) const
  {
    return { geometry_, cells_.mesh().cells[vertex], cells_.sitesAround(vertex) };
  }

  const TriangleMesh mesh_ = box({ kHalf[0], kHalf[1], kHalf[2] });
  const MeshCrossings box_{ mesh_, offCentreGrid(mesh_, kSpacing), 25.0 };
  const AxisGeometry geometry_ = box_.geometry();
  const SeamCells cells_{ geometry_, box_.crossings(), { 0, box_.grid().dimensions[2] } };
};

} // namespace

TEST_F(SeamsOfABox, AreNearTheirCells)
{
  ASSERT_GT(cells_.vertices().size(), 100u);
  EXPECT_LT(cells_.vertices().size(), cells_.mesh().cells.size() / 2);
  for (const std::uint32_t vertex : cells_.vertices())
  {
    const glm::dvec3 centre = geometry_.frame.sample(glm::dvec3(cells_.mesh().cells[vertex]) + 0.5);
    const auto walls = wallDistances(this->worldOf(centre));
    EXPECT_LT(walls[2] - walls[0], 6.0); // a cell beside one that a seam passes
  }
}

TEST_F(SeamsOfABox, PassOnlyTheirCells)
{
  for (const Point3& p : pointsOfSeams())
  {
    EXPECT_NE(this->vertexAt(p), kNone) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
}

TEST_F(SeamsOfABox, HaveExactPointsOfAllSheetsAround)
{
  std::size_t count = 0;
  for (const std::uint32_t vertex : cells_.vertices())
  {
    cells_.forPoints(vertex,
      [&](const BisectorPoint& point)
      {
        const auto walls = wallDistances(this->worldOf(point.position));
        EXPECT_NEAR(point.radius(), walls[0], kExact);
        EXPECT_NEAR(glm::distance(point.position, point.b.point), walls[0], kExact);
        if (point.separationAngle() >
          geometry_.limits.angle) // not where a face changes to its own edge
        {
          EXPECT_NEAR(walls[0], walls[1], kExact);
          ++count;
        }
      });
  }
  EXPECT_GT(count, 3 * cells_.vertices().size());
}

// In every cell on both sides of a point, where three walls are equally far away.
TEST_F(SeamsOfABox, HaveEndsInTheirCells)
{
  for (const Point3& p : pointsOfSeams())
  {
    const std::size_t vertex = this->vertexAt(p);
    ASSERT_NE(vertex, kNone);
    const CellSides sides = this->sidesOf(vertex);
    std::vector<double> ways;
    for (const CellSides::SeamEnd& end : sides.seamEnds())
    {
      const Point3 place = this->worldOf(end.position);
      const auto walls = wallDistances(place);
      if (walls[2] - walls[0] > kExact)
      {
        continue; // behind a wall that the cell does not see
      }
      for (const int side : end.sides)
      {
        EXPECT_NEAR(sides.distanceFrom(side, end.position), walls[0], kExact);
      }
      ways.push_back(place[1] - p[1]); // along both seams
    }
    ASSERT_GE(ways.size(), 2u) << p[0] << ' ' << p[1] << ' ' << p[2];
    EXPECT_LE(*std::min_element(ways.begin(), ways.end()), kExact * kSpacing);
    EXPECT_GE(*std::max_element(ways.begin(), ways.end()), -kExact * kSpacing);
  }
}

TEST_F(SeamsOfABox, KnowTheSideOfAPoint)
{
  for (const std::uint32_t vertex : cells_.vertices())
  {
    CellSides sides = this->sidesOf(vertex);
    ASSERT_GE(sides.size(), 2u);
    ASSERT_LE(sides.size(), 6u); // as a box has, though each has two faces
    const BisectorPoint& point = cells_.knownPoint(vertex);
    const int a = sides.sideOf(point.a, point.position);
    const int b = sides.sideOf(point.b, point.position);
    ASSERT_GE(a, 0);
    ASSERT_GE(b, 0);
    EXPECT_NE(a, b);
    EXPECT_TRUE(sides.areWide(a, b));
    EXPECT_NEAR(sides.distanceFrom(a, point.position), point.radius(), kExact);
    EXPECT_FALSE(sides.add({ point.a.site, point.position }));
  }
}

#include "ranks/axis/solid_piece.h"

#include "lib/ranks/simulated_ranks.h"
#include "thinning/sound_cells.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr int kLength = 8;

/// A strip of quads along x, all of it known on every rank.
SolidPiece strip(const CornerNumbers& corners)
{
  SolidPiece solid;
  for (int y = 1; y <= 2; ++y)
  {
    for (int x = 1; x <= kLength; ++x)
    {
      const glm::ivec3 position(x, y, 1);
      solid.numbers.push_back(corners.of(position));
      solid.axis.points.points.push_back({ glm::dvec3(position), {}, {} });
      solid.axis.points.moved.push_back(0);
    }
  }
  for (std::int64_t x = 0; x + 1 < kLength; ++x)
  {
    solid.axis.quads.push_back({ x, x + 1, kLength + x + 1, kLength + x });
  }
  solid.own.resize(solid.numbers.size(), 1);
  return solid;
}

/// Where points of the far side go: so near to the other that some quads have no area left.
glm::dvec3 moved(const glm::dvec3& x)
{
  return x.y > 1.5 && x.x > 2.5 && x.x < 6.5 ? glm::dvec3(x.x, 1.0 + 1e-4 * x.x, x.z) : x;
}

} // namespace

TEST(SolidPiece, TakesPointsBackThatLeaveNoAreaAcrossCuts)
{
  Grid grid;
  grid.dimensions = { kLength + 2, 4, 4 };
  const CornerNumbers corners(grid);
  SolidPiece whole = strip(corners);
  const std::vector<BisectorPoint> before = whole.axis.points.points;
  for (BisectorPoint& point : whole.axis.points.points)
  {
    point.position = moved(point.position);
  }
  const std::vector<BisectorPoint> unsound = whole.axis.points.points;
  keepCellsSound(before, whole.axis);
  std::size_t restored = 0;
  for (std::size_t p = 0; p < unsound.size(); ++p)
  {
    restored += unsound[p].position != whole.axis.points.points[p].position ? 1 : 0;
  }
  ASSERT_GT(restored, 0U);
  for (const int ranks : { 2, 3, 5 })
  {
    const std::vector<Extent> extents = partsOfGrid(grid, ranks);
    SimulatedRanks(ranks).run(
      [&](Communicator& communicator)
      {
        const GridShare share(grid, extents, communicator.rank());
        SolidPiece solid = strip(corners);
        std::vector<BisectorPoint>& points = solid.axis.points.points;
        for (std::size_t p = 0; p < points.size(); ++p)
        {
          solid.own[p] = share.owns(corners.cell(solid.numbers[p])) ? 1 : 0;
          if (solid.own[p] != 0)
          {
            points[p].position = moved(points[p].position);
          }
        }
        keepSound(communicator, share, corners, before, solid);
        for (std::size_t p = 0; p < points.size(); ++p)
        {
          if (solid.own[p] != 0)
          {
            EXPECT_EQ(points[p].position, whole.axis.points.points[p].position);
          }
        }
      });
  }
}

#include "ranks/field/inside_part.h"
#include "sign/inside_query.h"

#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Number of positions in the ranks' parts where they disagree with one process.
int differences(const TriangleMesh& mesh, int ranks, SignMethod sign = SignMethod::Pseudonormal)
{
  const Grid grid = gridAround(mesh, 50);
  const std::vector<Extent> extents = partsOfGrid(grid, ranks);
  const GridFrame frame(grid);
  const InsideQuery whole(mesh, analyseConnectivity(mesh), frame);
  std::vector<int> different(extents.size(), 0);
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      DistanceFieldOptions options;
      options.sign = sign;
      RunStatistics statistics;
      const Extent& extent = extents[rank];
      RankField field(communicator, pieceOf(mesh, rank, atRandom(ranks)), grid, options,
        Run(Execution{ 1, nullptr }), statistics);
      field.bring(communicator, extent, extent);
      field.closeHoles(communicator);
      InsidePart part(communicator, field, extent);
      if (extent.empty())
      {
        return;
      }
      part.prepare();
      std::mt19937 random(static_cast<unsigned>(rank));
      std::uniform_real_distribution<double> share(0.0, 1.0);
      for (int i = 0; i < 2000; ++i)
      {
        glm::dvec3 index;
        for (int axis = 0; axis < 3; ++axis)
        {
          const double at = share(random) * (extent.size(axis) - 1);
          // Grid points as well: these lie on lines through edges and corners.
          index[axis] = extent.min[axis] + (i % 2 == 0 ? at : std::floor(at));
        }
        const glm::dvec3 x = frame.sample(index);
        different[rank] += part.contains(x) == whole.contains(x) ? 0 : 1;
      }
    });
  int sum = 0;
  for (const int count : different)
  {
    sum += count;
  }
  return sum;
}

} // namespace

TEST(InsidePart, IsThatOfTheWholeSurface)
{
  for (const int ranks : { 1, 3, 8 })
  {
    EXPECT_EQ(differences(numbered(shell(0.5, 1.0, 3)), ranks), 0) << ranks;
    EXPECT_EQ(differences(numbered(torus(0.8, 0.23, 60, 30)), ranks), 0) << ranks;
  }
}

TEST(InsidePart, OfASurfaceInsideOutIsThatOfTheSolid)
{
  TriangleMesh mesh = torus(0.8, 0.23, 40, 20);
  for (auto& triangle : mesh.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
  EXPECT_EQ(differences(numbered(mesh), 4), 0);
}

TEST(InsidePart, OfASurfaceWithHolesIsThatOfTheWhole)
{
  TriangleMesh half = icosphere(1.0, 3);
  half.triangles.resize(half.triangles.size() / 2);
  for (const int ranks : { 1, 3, 8 })
  {
    EXPECT_EQ(differences(numbered(withoutLoosePoints(half)), ranks, SignMethod::Winding), 0);
    EXPECT_EQ(differences(damagedSolids(9), ranks, SignMethod::Winding), 0);
    EXPECT_EQ(differences(moebiusStrips(), ranks, SignMethod::Winding), 0);
  }
}

TEST(InsidePart, CountsSolidsThatOverlap)
{
  // Where both are, the winding number is 2.
  const TriangleMesh mesh =
    appended(icosphere(0.6, 2), translated(icosphere(0.6, 2), { 0.413, 0.121, 0.077 }));
  EXPECT_EQ(differences(numbered(mesh), 4), 0);
}

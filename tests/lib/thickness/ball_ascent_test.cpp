// Large balls around points, without an axis.
#include "thickness/ball_ascent.h"

#include "culling/group_tree.h"
#include "sites/site_set.h"
#include "support/mesh_search.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

using namespace medial;
using namespace medial::test;

namespace
{

/// All that an ascent needs. Lengths of it are voxels of the grid.
struct Solid
{
  explicit Solid(TriangleMesh ofSolid)
    : mesh(std::move(ofSolid))
    , connectivity(analyseConnectivity(mesh))
    , grid(makeGrid(mesh.bounds(), 40, 0.05))
    , frame(grid)
    , sites(mesh, connectivity, frame)
    , tree(sites, connectivity, roundingNear(frame.reach(), sites))
    , query(tree)
  {
  }

  TriangleMesh mesh;
  MeshConnectivity connectivity;
  Grid grid;
  GridFrame frame;
  SiteSet sites;
  GroupTree tree;
  SiteQuery query;
};

Point3 randomPoint(std::mt19937& random, const Bounds& bounds)
{
  Point3 point;
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = std::uniform_real_distribution<>(bounds.min[axis], bounds.max[axis])(random);
  }
  return point;
}

} // namespace

TEST(BallAscent, BallsHoldThePointAndNoSurface)
{
  for (const TriangleMesh& mesh : { ellipsoid(1.0, 0.7, 0.4, 3), torus(1.0, 0.4, 48, 24),
         appended(box({ 1.0, 0.8, 0.7 }), flipOrientation(box({ 0.5, 0.4, 0.3 }))) })
  {
    const Solid solid(mesh);
    const MeshSearch search(solid.mesh);
    BallAscent ascent(solid.query, solid.frame);
    std::mt19937 random(3);
    int found = 0;
    for (int i = 0; i < 300; ++i)
    {
      const Point3 point = randomPoint(random, solid.mesh.bounds());
      const auto ball = ascent.largerBallAround(solid.frame.toLocal(point), 1.0);
      if (ball)
      {
        ++found;
        const Point3 centre = solid.frame.toWorld(ball->centre);
        const double radius = ball->radius * solid.frame.unit;
        EXPECT_NEAR(radius, search.closest(centre).distance, 1e-9);
        EXPECT_LE(distance(centre, point), radius + 1e-9);
        EXPECT_GT(radius, search.closest(point).distance);
      }
    }
    EXPECT_GT(found, 200);
  }
}

// Near the surface there is one place where to look for the largest ball: inwards.
TEST(BallAscent, NearTheFacesOfABoxFindsTheLargestBall)
{
  const Solid solid(box({ 1.0, 0.7, 0.4 }));
  BallAscent ascent(solid.query, solid.frame);
  for (double x = -0.55; x < 0.6; x += 0.11)
  {
    for (double y = -0.25; y < 0.3; y += 0.05)
    {
      for (const double z : { -0.399, 0.35, 0.39 })
      {
        const auto ball = ascent.largerBallAround(solid.frame.toLocal({ x, y, z }), 1.0);
        ASSERT_TRUE(ball);
        EXPECT_NEAR(ball->radius * solid.frame.unit, 0.4, 0.01 * solid.frame.unit);
      }
    }
  }
}

TEST(BallAscent, FindsNothingWhereAKnownBallIsAsLarge)
{
  const Solid solid(box({ 1.0, 0.7, 0.4 }));
  BallAscent ascent(solid.query, solid.frame);
  const glm::dvec3 point = solid.frame.toLocal({ 0.1, 0.2, 0.39 });
  EXPECT_TRUE(ascent.largerBallAround(point, 0.3 / solid.frame.unit));
  EXPECT_FALSE(ascent.largerBallAround(point, 0.4 / solid.frame.unit));
}

TEST(BallAscent, FindsNothingOnTheSurfaceAndInTheMiddle)
{
  const Solid solid(icosphere(1.0, 3));
  BallAscent ascent(solid.query, solid.frame);
  EXPECT_FALSE(ascent.largerBallAround(solid.frame.toLocal(solid.mesh.points.front()), 1.0));
  const auto ball = ascent.largerBallAround(solid.frame.toLocal({ 0.0, 0.0, 0.0 }), 1.0);
  EXPECT_LE(ball ? ball->radius * solid.frame.unit : 1.0, 1.0);
}

#include "sign/inside_query.h"

#include "support/brute_force.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

using namespace medial;
using namespace medial::test;

namespace
{

/// Expects the answers of brute force on a mesh that faces outwards, whichever way it is given.
void expectInside(const TriangleMesh& outwards, bool closed)
{
  for (const TriangleMesh& mesh : { outwards, flipOrientation(outwards) })
  {
    const LocalCoordinates local = LocalCoordinates::around(mesh.bounds(), 0.0);
    const InsideQuery inside(mesh, analyseConnectivity(mesh), local);
    EXPECT_EQ(inside.closed(), closed);
    for (const Point3& point : randomPoints({ { -1.5, -1.5, -1.5 }, { 1.5, 1.5, 1.5 } }, 1000, 9))
    {
      ASSERT_EQ(inside.contains(local.toLocal(point)), windingNumber(outwards, point) > 0.5);
    }
  }
}

} // namespace

TEST(InsideQuery, AgreesWithBruteForce)
{
  expectInside(shell(0.6, 1.0, 2), true);
  expectInside(lPrism(1.0, 0.5), true);
  TriangleMesh open = icosphere(1.0, 2);
  open.triangles.resize(open.triangles.size() - 3);
  open.triangleCells.resize(open.triangles.size());
  expectInside(open, false);
}

TEST(InsideQuery, NothingIsInsideOfSegments)
{
  const TriangleMesh mesh = makeMesh({ { 0, 0, 0 }, { 1, 1, 1 } }, {}, { { 0, 1 } });
  const InsideQuery inside(mesh, analyseConnectivity(mesh),
    LocalCoordinates::around(mesh.bounds(), 0.0));
  EXPECT_FALSE(inside.closed());
  EXPECT_FALSE(inside.contains({ 0.0, 0.0, 0.0 }));
}

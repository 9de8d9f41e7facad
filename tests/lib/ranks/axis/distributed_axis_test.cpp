#include "medial/compute_medial_axis.h"
#include "medial/ranks.h"

#include "axis_of_ranks.h"
#include "lib/ranks/pieces.h"
#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

TEST(DistributedAxis, OfATorusAndABoxIsThatOfOneProcess)
{
  expectSameAxisOfAllPartitions(caseOf(torusAndBox(), 70));
}

TEST(DistributedAxis, OfBoxesIsThatOfOneProcess)
{
  // Sheets with seams and creases, in a grid that is not even.
  AxisCase of = caseOf(numbered(box({ 1.5, 1.1, 0.7 })), 90);
  of.grid.spacing[1] *= 1.3;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfBothSidesIsThatOfOneProcess)
{
  AxisCase of = caseOf(torusAndBox(), 61);
  of.side = Side::Both;
  of.angle = 25.0;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfASymmetricMeshIsThatOfOneProcess)
{
  // A round wall: sheets of facets, curves, and sites at equal distance.
  expectSameAxisOfAllPartitions({ numbered(shell(0.5, 1.0, 3)), symmetricGrid() });
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
    AxisCase of = caseOf(damagedSolids(3), 44);
    of.sign = sign;
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
  AxisCase of = caseOf(numbered(withoutLoosePoints(mesh)), 54);
  of.sign = SignMethod::Winding;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfPartsThatFaceDifferentWaysIsThatOfOneProcess)
{
  AxisCase of = caseOf(numbered(appended(flipOrientation(icosphere(0.5, 2)),
                         translated(box({ 0.21, 0.33, 0.17 }), { 0.9, -0.05, 0.13 }))),
    50);
  of.side = Side::Both;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, WithLimitsIsThatOfOneProcess)
{
  AxisCase of = caseOf(torusAndBox(), 60);
  of.lambda = 0.1;
  of.radius = 0.12;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfPointsIsThatOfOneProcess)
{
  AxisCase of = caseOf(torusAndBox(), 60);
  of.representation = Representation::Points;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfFacesIsThatOfOneProcess)
{
  AxisCase of = caseOf(torusAndBox(), 60);
  of.representation = Representation::Faces;
  expectSameAxisOfAllPartitions(of);
}

TEST(DistributedAxis, OfThinPartsIsThatOfOneProcess)
{
  // Curves, most of whose points become one with others.
  expectSameAxisOfAllPartitions(caseOf(numbered(uvCapsule(0.05, 1.0, 24)), 130));
}

TEST(DistributedAxis, OfSlicesOfThickSlabsIsThatOfOneProcess)
{
  // More slices than the thickest slab has, where the order of crossings changes.
  const AxisCase of = caseOf(numbered(uvCapsule(0.3, 1.0, 24)), 150);
  ASSERT_GT(of.grid.dimensions[2], 128);
  const MedialAxis whole = wholeAxisOf(of);
  expectWhole(whole, axisOfRanks(of, partsOfGrid(of.grid, 5), onTheLast(5)));
}

class DistributedAxisOfModels : public testing::TestWithParam<std::string>
{
};

TEST_P(DistributedAxisOfModels, IsThatOfOneProcess)
{
  expectSameAxisAtAngles(
    caseOf(numbered(buildTriangleMesh(loadModel(*modelPath(GetParam())))), 64));
}

INSTANTIATE_TEST_SUITE_P(Models, DistributedAxisOfModels, testing::ValuesIn(modelsForRanks()));
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DistributedAxisOfModels);

#include "medial/compute_medial_axis.h"
#include "medial/ranks.h"

#include "axis_of_ranks.h"
#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

AxisCase preserved(AxisCase of)
{
  of.topology = Topology::Preserve;
  return of;
}

/// Boxes that share a part of a face, and a ball that nearly touches one of them: all of them would
/// be one solid of voxels.
TriangleMesh touchingBodies()
{
  TriangleMesh mesh =
    appended(box({ 0.5, 0.4, 0.3 }), translated(box({ 0.3, 0.3, 0.3 }), { 0.8, 0.1, 0.05 }));
  return numbered(appended(mesh, translated(icosphere(0.3, 2), { 0.0, 0.72, 0.0 })));
}

} // namespace

TEST(PreservedAxisOfRanks, OfATorusAndABoxIsThatOfOneProcess)
{
  expectSameAxisOfAllPartitions(preserved(caseOf(torusAndBox(), 70)));
}

TEST(PreservedAxisOfRanks, OfABoxInAnUnevenGridIsThatOfOneProcess)
{
  AxisCase of = preserved(caseOf(numbered(box({ 1.5, 1.1, 0.7 })), 70));
  of.grid.spacing[1] *= 1.3;
  expectSameAxisOfAllPartitions(of);
}

TEST(PreservedAxisOfRanks, OfBothSidesIsThatOfOneProcess)
{
  AxisCase of = preserved(caseOf(torusAndBox(), 51));
  of.side = Side::Both;
  of.angle = 25.0;
  expectSameAxisOfAllPartitions(of);
}

TEST(PreservedAxisOfRanks, OfTheOutsideIsThatOfOneProcess)
{
  AxisCase of = preserved(caseOf(torusAndBox(), 45));
  of.side = Side::Exterior;
  of.sign = SignMethod::Winding;
  expectSameAxisOfAllPartitions(of);
}

TEST(PreservedAxisOfRanks, OfASymmetricMeshIsThatOfOneProcess)
{
  expectSameAxisOfAllPartitions(preserved({ numbered(shell(0.5, 1.0, 3)), symmetricGrid() }));
}

TEST(PreservedAxisOfRanks, OfBodiesThatTouchIsThatOfOneProcess)
{
  for (const SignMethod sign : { SignMethod::Pseudonormal, SignMethod::Winding })
  {
    AxisCase of = preserved(caseOf(touchingBodies(), 58));
    of.sign = sign;
    ASSERT_EQ(wholeAxisOf(of).solid->components, 3);
    expectSameAxisOfAllPartitions(of);
  }
}

TEST(PreservedAxisOfRanks, OfCurvesIsThatOfOneProcess)
{
  // A curve that runs through the parts of many ranks.
  expectSameAxisOfAllPartitions(preserved(caseOf(numbered(uvCapsule(0.1, 1.0, 24)), 110)));
}

TEST(PreservedAxisOfRanks, OfARingIsThatOfOneProcess)
{
  expectSameAxisOfAllPartitions(preserved(caseOf(numbered(torus(1.0, 0.2, 64, 24)), 64)));
}

TEST(PreservedAxisOfRanks, OfAnOpenSurfaceIsThatOfOneProcess)
{
  const TriangleMesh mesh = numbered(plates(0.3, 0.8));
  expectSameAxisOfAllPartitions(preserved({ mesh, gridAround(mesh, 40), SignMethod::None }));
}

TEST(PreservedAxisOfRanks, OfDamagedSolidsIsThatOfOneProcess)
{
  AxisCase of = preserved(caseOf(damagedSolids(3), 44));
  of.sign = SignMethod::Winding;
  of.side = Side::Both;
  expectSameAxisOfAllPartitions(of);
}

TEST(PreservedAxisOfRanks, WithLimitsIsThatOfOneProcess)
{
  AxisCase of = preserved(caseOf(torusAndBox(), 60));
  of.lambda = 0.1;
  of.radius = 0.12;
  expectSameAxisOfAllPartitions(of);
}

TEST(PreservedAxisOfRanks, OfFacesIsThatOfOneProcess)
{
  AxisCase of = preserved(caseOf(torusAndBox(), 50));
  of.representation = Representation::Faces;
  expectSameAxisOfAllPartitions(of);
}

TEST(PreservedAxisOfRanks, BroughtTogetherKeepsTheTopologyOfTheSolid)
{
  const AxisCase of = preserved(caseOf(torusAndBox(), 40));
  const MedialAxis whole = wholeAxisOf(of);
  const std::vector<AxisPiece> pieces = axisOfRanks(of, partsOfGrid(of.grid, 3), atRandom(3));
  MedialAxis gathered;
  SimulatedRanks(3).run(
    [&](Communicator& communicator)
    {
      const MedialAxis axis = gatherMedialAxis(communicator, pieces[communicator.rank()]);
      if (communicator.rank() == 0)
      {
        gathered = axis;
      }
    });
  ASSERT_TRUE(gathered.solid);
  EXPECT_EQ(numbersOf(*gathered.solid), numbersOf(*whole.solid));
  EXPECT_EQ(cellsOf(gathered), cellsOf(whole));
}

TEST(PreservedAxisOfRanks, InOtherPartsThanThoseOfTheFieldIsThatOfOneProcess)
{
  // Bodies with colours of their own meet at cuts.
  const AxisCase of = preserved(caseOf(touchingBodies(), 58));
  const MedialAxis whole = wholeAxisOf(of);
  const auto [x, y, z] = of.grid.wholeExtent().max;
  const std::vector<Extent> extents{ { { 0, 0, 0 }, { x, y, 20 } }, { { 0, 0, 21 }, { x, y, 21 } },
    {}, { { 0, 0, 22 }, { 17, y, z } }, { { 18, 0, 22 }, { x, y, z } } };
  const std::vector<Extent> others{ extents[3], extents[2], extents[4], extents[0], extents[1] };
  expectWhole(whole, axisOfRanks(of, extents, atRandom(5), others));
  expectWhole(whole, axisOfRanks(of, others, atRandom(5), extents));
}

TEST(PreservedAxisOfRanks, DoesNotMoveTheVolume)
{
  // What it takes to make the axis elsewhere than the field, of a solid that fills half of its
  // grid.
  const auto bytesMoved = [](int resolution)
  {
    const AxisCase of = preserved(caseOf(numbered(box({ 1.0, 1.0, 1.0 })), resolution));
    const auto [x, y, z] = of.grid.wholeExtent().max;
    const std::vector<Extent> extents{ { { 0, 0, 0 }, { x, y, z / 2 } },
      { { 0, 0, z / 2 + 1 }, { x, y, z } } };
    const auto bytesWith = [&](const std::vector<Extent>& axisExtents)
    {
      std::vector<RankCounts> counts;
      axisOfRanks(of, extents, atRandom(2), axisExtents, &counts);
      return static_cast<double>(counts[0].bytesSent + counts[1].bytesSent);
    };
    return bytesWith({ extents[1], extents[0] }) - bytesWith(extents);
  };
  const double few = bytesMoved(48);
  ASSERT_GT(few, 0.0);
  EXPECT_LT(bytesMoved(96) / few, std::pow(2.0, 2.3));
}

class PreservedAxisOfModels : public testing::TestWithParam<std::string>
{
};

TEST_P(PreservedAxisOfModels, IsThatOfOneProcess)
{
  expectSameAxisAtAngles(
    preserved(caseOf(numbered(buildTriangleMesh(loadModel(*modelPath(GetParam())))), 60)));
}

INSTANTIATE_TEST_SUITE_P(Models, PreservedAxisOfModels, testing::ValuesIn(modelsForRanks()));
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(PreservedAxisOfModels);

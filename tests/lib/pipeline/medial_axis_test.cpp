#include "medial/compute_medial_axis.h"

#include "support/brute_force.h"
#include "support/medial_checks.h"
#include "support/medial_truth.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

class MedialAxisOf : public testing::TestWithParam<Named<MedialTruth>>
{
protected:
  MedialAxis compute(Representation representation) const
  {
    MedialAxisOptions options;
    options.angle = truth_.angle;
    options.representation = representation;
    return computeMedialAxis(truth_.shape, grid_, options);
  }

  /// Tolerances in voxels.
  void expectOnAxis(const std::vector<Point3>& points, double onSheets, double mean,
    double nearCurves = 0.0) const
  {
    const double h = truth_.spacing;
    const double reach = thickness_ + nearCurves * h;
    const AxisErrors errors = axisErrors(truth_, points, reach);
    EXPECT_LE(errors.sheetMax, onSheets * h);
    EXPECT_LE(errors.sheetMean, mean * h);
    EXPECT_LE(errors.curveMax, reach);
  }

  /// Every point of the true axis has a computed point nearby.
  void expectCovered(const std::vector<Point3>& points) const
  {
    EXPECT_LE(uncovered(truth_, points, 2.0 * truth_.spacing), thickness_);
  }

  const MedialTruth truth_ = GetParam().make();
  const Grid grid_ = offCentreGrid(truth_.shape, truth_.spacing);
  const double thickness_ = thickening(truth_.spacing, truth_.angle);
};

} // namespace

TEST_P(MedialAxisOf, SurfaceIsTheTrueAxis)
{
  const MedialAxis axis = compute(Representation::Surface);
  expectOnAxis(axis.points, 0.3, 0.07);
  expectCovered(axis.points);
  expectConsistent(truth_.shape, grid_, axis, Representation::Surface);
}

TEST_P(MedialAxisOf, PointsAreOnTheTrueAxis)
{
  const MedialAxis axis = compute(Representation::Points);
  expectOnAxis(axis.points, 0.3, 0.07);
  expectCovered(axis.points);
  expectConsistent(truth_.shape, grid_, axis, Representation::Points);
}

TEST_P(MedialAxisOf, VoxelFacesAreNextToTheTrueAxis)
{
  const MedialAxis axis = compute(Representation::Faces);
  expectOnAxis(cellCentres(axis), 0.5, 0.35);
  // Their corners are half the diagonal of a face away.
  expectOnAxis(axis.points, 0.87, 0.5, std::sqrt(0.5));
  expectCovered(axis.points);
  expectConsistent(truth_.shape, grid_, axis, Representation::Faces);
}

INSTANTIATE_TEST_SUITE_P(Shapes, MedialAxisOf, testing::ValuesIn(medialTruths()), kNameOfParameter);

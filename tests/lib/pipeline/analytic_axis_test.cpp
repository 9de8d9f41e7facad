#include "support/analytic_axes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

using namespace medial;
using namespace medial::test;

namespace
{

/// Grid steps by which facets and selection thicken a curve.
double curveTolerance(double angle)
{
  constexpr double kDegree = 3.14159265358979 / 180.0;
  return 0.5 / std::sin(0.5 * angle * kDegree) + 0.5;
}

class AnalyticAxisOf : public testing::TestWithParam<Named<AnalyticAxis>>
{
};

} // namespace

/// Positions in grid steps stay within bounds at every resolution, and errors in world units fall
/// with the spacing. The figures are printed for docs/ACCURACY.md.
TEST_P(AnalyticAxisOf, ErrorsAreSmallAndFallWithTheSpacing)
{
  const AnalyticAxis axis = GetParam().make();
  std::array<AnalyticErrors, 3> errors;
  for (int level = 0; level < 3; ++level)
  {
    const double spacing = axis.spacing / (1 << level);
    errors[level] = analyticErrors(axis, spacing);
    const AnalyticErrors& e = errors[level];
    std::printf("| %s | %.4g | %zu | %.3f / %.4f | %.3f / %.4f | ", GetParam().name.c_str(),
      spacing, e.points, e.positionMax, e.positionMean, e.radiusMax, e.radiusMean);
    axis.isCurve ? std::printf("| ") : std::printf("%.2f / %.2f | ", e.angleMax, e.angleMean);
    axis.area > 0.0 ? std::printf("%.2f |\n", 100.0 * e.area) : std::printf("|\n");
    if (axis.isCurve)
    {
      ASSERT_GT(e.points, 0u);
      EXPECT_LE(e.positionMax, curveTolerance(axis.angle));
      continue;
    }
    ASSERT_GT(e.points, 50u);
    EXPECT_LE(e.positionMax, 0.3);
    EXPECT_LE(e.positionMean, 0.05);
    EXPECT_LE(e.radiusMax, 0.3);
  }
  if (axis.isCurve)
  {
    return;
  }
  // At least first order in world units: the mean in grid steps must not grow.
  EXPECT_LE(errors[2].positionMean, 1.1 * errors[0].positionMean + 1e-4);
  EXPECT_LE(errors[2].angleMean, errors[0].angleMean + 0.05);
  EXPECT_LE(errors[2].area, errors[0].area + 1e-4);
  EXPECT_LE(errors[2].area, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Shapes, AnalyticAxisOf, testing::ValuesIn(analyticAxes()),
  kNameOfParameter);

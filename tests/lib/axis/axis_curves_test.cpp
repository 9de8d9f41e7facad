#include "medial/axis_curves.h"
#include "medial/compute_medial_axis.h"

#include "support/medial_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

using Ids = std::vector<std::int64_t>;

AxisEdges polygons(const std::vector<Ids>& cells, const std::vector<AxisEdges::Edge>& lines = {})
{
  AxisEdges edges;
  edges.lines = lines;
  for (const Ids& cell : cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      edges.polygonEdges.push_back({ cell[i], cell[(i + 1) % cell.size()] });
    }
  }
  return edges;
}

/// Three quads that share the edge 0-1.
AxisEdges threePages()
{
  return polygons({ { 0, 1, 3, 2 }, { 0, 1, 5, 4 }, { 0, 1, 7, 6 } });
}

std::vector<Ids> pointsOf(const std::vector<AxisCurve>& curves, AxisFeature kind)
{
  std::vector<Ids> points;
  for (const AxisCurve& curve : curves)
  {
    if (curve.kind == kind)
    {
      points.push_back(curve.points);
    }
  }
  return points;
}

double distanceToBoxEdges(const Point3& p, const Point3& halfSides)
{
  // Of the folded point, to the nearest of the three edges at its corner.
  double min = 1e300;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double u = halfSides[(axis + 1) % 3] - std::abs(p[(axis + 1) % 3]);
    const double v = halfSides[(axis + 2) % 3] - std::abs(p[(axis + 2) % 3]);
    min = std::min(min, std::hypot(u, v));
  }
  return min;
}

} // namespace

TEST(MedialCurves, PagesOfABookMeetInASeamWithRimsAround)
{
  const std::vector<AxisFeature> features = axisFeatures(threePages(), 9);
  EXPECT_EQ(features[0], AxisFeature::Junction);
  EXPECT_EQ(features[1], AxisFeature::Junction);
  EXPECT_EQ(features[2], AxisFeature::Rim);
  EXPECT_EQ(features[7], AxisFeature::Rim);
  EXPECT_EQ(features[8], AxisFeature::Point);
  const std::vector<AxisCurve> curves = axisCurves(threePages(), 9);
  EXPECT_EQ(pointsOf(curves, AxisFeature::Seam), (std::vector<Ids>{ { 0, 1 } }));
  EXPECT_EQ(pointsOf(curves, AxisFeature::Rim),
    (std::vector<Ids>{ { 0, 2, 3, 1 }, { 0, 4, 5, 1 }, { 0, 6, 7, 1 } }));
}

TEST(MedialCurves, ASeamInTheMiddleIsNoJunction)
{
  std::vector<Ids> cells;
  for (const Ids& page : std::vector<Ids>{ { 3, 4, 5 }, { 6, 7, 8 }, { 9, 10, 11 } })
  {
    cells.push_back({ 0, 1, page[1], page[0] });
    cells.push_back({ 1, 2, page[2], page[1] });
  }
  const AxisEdges edges = polygons(cells);
  EXPECT_EQ(axisFeatures(edges, 12)[1], AxisFeature::Seam);
  EXPECT_EQ(pointsOf(axisCurves(edges, 12), AxisFeature::Seam), (std::vector<Ids>{ { 0, 1, 2 } }));
}

TEST(MedialCurves, TheRimOfASingleQuadIsALoop)
{
  const std::vector<AxisCurve> curves = axisCurves(polygons({ { 0, 1, 2, 3 } }), 4);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].points, (Ids{ 0, 1, 2, 3, 0 }));
}

TEST(MedialCurves, LinesAreCurvesThatEndAtSheetsAndForks)
{
  // A quad, a line of two edges away from it, and a fork.
  const AxisEdges edges = polygons({ { 0, 1, 2, 3 } }, { { 4, 3 }, { 4, 5 }, { 5, 6 }, { 5, 7 } });
  const std::vector<AxisFeature> features = axisFeatures(edges, 8);
  EXPECT_EQ(features[3], AxisFeature::Junction);
  EXPECT_EQ(features[4], AxisFeature::Curve);
  EXPECT_EQ(features[5], AxisFeature::Junction);
  EXPECT_EQ(features[6], AxisFeature::Curve);
  EXPECT_EQ(pointsOf(axisCurves(edges, 8), AxisFeature::Curve),
    (std::vector<Ids>{ { 3, 4, 5 }, { 5, 6 }, { 5, 7 } }));
}

TEST(MedialCurves, EveryEdgeComesOnce)
{
  const TriangleMesh mesh = lPrism(1.0, 0.6);
  const MedialAxis axis = computeMedialAxis(mesh, offCentreGrid(mesh, 0.057));
  const AxisEdges edges = edgesOf(axis);
  std::vector<AxisEdges::Edge> seen;
  for (const AxisCurve& curve : axisCurves(edges, axis.points.size()))
  {
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      seen.push_back({ std::min(curve.points[i], curve.points[i + 1]),
        std::max(curve.points[i], curve.points[i + 1]) });
    }
  }
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
  EXPECT_FALSE(seen.empty());
  EXPECT_EQ(axis.feature, axisFeatures(edges, axis.points.size()));
}

/// The seams of a box run along the middle rectangle and from its corners to those of the box; its
/// rims along the edges.
TEST(MedialCurves, SeamsAndRimsOfABoxLieWhereItsSheetsMeetAndEnd)
{
  const Point3 halfSides{ 1.0, 0.8, 0.5 };
  constexpr double kSpacing = 0.037;
  const TriangleMesh mesh = box(halfSides);
  const MedialAxis axis = computeMedialAxis(mesh, offCentreGrid(mesh, kSpacing));
  int seams = 0;
  int rims = 0;
  for (std::size_t p = 0; p < axis.points.size(); ++p)
  {
    const Point3& x = axis.points[p];
    std::vector<double> toSides;
    for (int i = 0; i < 3; ++i)
    {
      toSides.push_back(halfSides[i] - std::abs(x[i]));
    }
    std::sort(toSides.begin(), toSides.end());
    if (axis.feature[p] == AxisFeature::Seam)
    {
      ++seams;
      // Three sides at equal distance, or the middle rectangle with the sheets at its border.
      EXPECT_NEAR(toSides[1], toSides[0], 0.3 * kSpacing);
    }
    if (axis.feature[p] == AxisFeature::Rim)
    {
      ++rims;
      EXPECT_LE(distanceToBoxEdges(x, halfSides), 2.5 * kSpacing);
    }
  }
  EXPECT_GT(seams, 50);
  EXPECT_GT(rims, 200);
}

// vtkMedialAxis: is the axis right?
#include "box_axis.h"

#include "medial/compute_medial_axis.h"

#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkConnectivityFilter.h>
#include <vtkDataArray.h>
#include <vtkMedialCurves.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace medial::test;
using medial::Point3;

/// Distances to the faces of the box, ascending; the axis is where the first two agree.
std::array<double, 6> faceDistances(const Point3& x)
{
  std::array<double, 6> distances;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    distances[2 * axis] = kHalfSides[axis] - x[axis];
    distances[2 * axis + 1] = kHalfSides[axis] + x[axis];
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

TEST(MedialAxisFilter, DefaultsAreThoseOfTheLibrary)
{
  vtkNew<vtkMedialAxis> axis;
  const medial::MedialAxisOptions options;
  EXPECT_EQ(axis->GetAngle(), options.angle);
  EXPECT_EQ(axis->GetAngle(), 60.0);
  EXPECT_EQ(axis->GetSide(), vtkMedialAxis::INTERIOR);
  EXPECT_EQ(options.side, medial::Side::Interior);
  EXPECT_EQ(axis->GetRepresentation(), vtkMedialAxis::SURFACE);
  EXPECT_EQ(options.representation, medial::Representation::Surface);
  EXPECT_EQ(axis->GetTopology(), vtkMedialAxis::SELECTED);
  EXPECT_EQ(options.topology, medial::Topology::Selected);
  EXPECT_FALSE(axis->GetGenerateDistanceField());
}

TEST(MedialAxisFilter, MinimumLambdaAndRadiusLimitTheAxis)
{
  auto axis = boxAxis();
  axis->SetRepresentationToPoints();
  axis->SetMinimumLambda(0.2);
  axis->Update();
  vtkPolyData* output = axis->GetOutput();
  ASSERT_GT(output->GetNumberOfPoints(), 100);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_GE(valueOf(output, "Lambda", i), 0.1999);
  }
  axis->SetMinimumLambda(0.0);
  axis->SetMinimumRadius(0.3);
  axis->Update();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_GE(valueOf(output, "Radius", i), 0.2999);
  }
}

// The seams of a box frame its middle rectangle and run from there to its corners.
TEST(MedialAxisFilter, CurvesOfABoxAreItsSeamsAndRims)
{
  auto axis = boxAxis();
  vtkNew<vtkMedialCurves> curves;
  curves->SetInputConnection(axis->GetOutputPort());
  curves->Update();
  vtkPolyData* output = curves->GetOutput();
  const std::vector<double> spacing = figures(axis->GetOutput(), "GridSpacing");
  ASSERT_EQ(spacing.size(), 3u);
  vtkDataArray* kinds = output->GetCellData()->GetArray("AxisFeature");
  ASSERT_NE(kinds, nullptr);
  int seamPoints = 0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const auto kind = static_cast<medial::AxisFeature>(kinds->GetTuple1(cell));
    EXPECT_TRUE(kind == medial::AxisFeature::Rim || kind == medial::AxisFeature::Seam);
    vtkIdList* ids = output->GetCell(cell)->GetPointIds();
    for (vtkIdType i = 0; kind == medial::AxisFeature::Seam && i < ids->GetNumberOfIds(); ++i)
    {
      ++seamPoints;
      const auto distances = faceDistances(pointOf(output, ids->GetId(i)));
      EXPECT_LE(distances[2] - distances[0], spacing[0]);
    }
  }
  EXPECT_GT(seamPoints, 100);
  curves->SeamsOff();
  curves->RimsOff();
  curves->Update();
  EXPECT_EQ(curves->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MedialAxisFilter, BoxHasItsAnalyticAxis)
{
  auto axis = boxAxis();
  axis->Update();
  vtkPolyData* output = axis->GetOutput();
  ASSERT_GT(output->GetNumberOfPoints(), 500);
  const std::vector<double> spacing = figures(axis->GetOutput(), "GridSpacing");
  ASSERT_EQ(spacing.size(), 3u);
  const double h = spacing[0];
  double offAxis = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Point3 x = pointOf(output, i);
    const auto distances = faceDistances(x);
    // A sheet bisects two faces: the distance from it is the difference of theirs over at most 2.
    EXPECT_LE(0.5 * (distances[1] - distances[0]), 0.5 * h) << "point " << i;
    offAxis += 0.5 * (distances[1] - distances[0]);
    EXPECT_NEAR(valueOf(output, "Radius", i), distances[0], 1e-2 * h) << "point " << i;
  }
  EXPECT_LE(offAxis / static_cast<double>(output->GetNumberOfPoints()), 0.1 * h);
}

TEST(MedialAxisFilter, AttributesFulfilTheirIdentities)
{
  auto axis = boxAxis();
  axis->Update();
  vtkPolyData* output = axis->GetOutput();
  const std::vector<double> spacing = figures(axis->GetOutput(), "GridSpacing");
  ASSERT_EQ(spacing.size(), 3u);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double radius = valueOf(output, "Radius", i);
    const double angle = valueOf(output, "SeparationAngle", i);
    EXPECT_GE(angle, 0.0);
    EXPECT_LE(angle, 180.0);
    EXPECT_NEAR(valueOf(output, "Lambda", i), radius * std::sin(0.5 * angle * M_PI / 180.0),
      1e-4 * radius);
    for (const char* name : { "ClosestPointA", "ClosestPointB" })
    {
      const Point3 closest = vectorOf(output, name, i);
      EXPECT_NEAR(boxDistance(kHalfSides, closest), 0.0, 1e-5) << name << " of point " << i;
      EXPECT_NEAR(distanceBetween(closest, pointOf(output, i)), radius, spacing[0])
        << name << " of point " << i;
    }
  }
}

TEST(MedialAxisFilter, ArraysHaveTheirNamesAndTypes)
{
  auto axis = boxAxis(17);
  axis->Update();
  vtkPointData* data = axis->GetOutput()->GetPointData();
  const struct
  {
    const char* name;
    int components;
  } expected[] = { { "Radius", 1 }, { "SeparationAngle", 1 }, { "Lambda", 1 },
    { "ClosestPointA", 3 }, { "ClosestPointB", 3 } };
  EXPECT_EQ(data->GetNumberOfArrays(), 6);
  ASSERT_NE(data->GetArray("AxisFeature"), nullptr);
  EXPECT_EQ(data->GetArray("AxisFeature")->GetDataType(), VTK_UNSIGNED_CHAR);
  for (const auto& array : expected)
  {
    ASSERT_NE(data->GetArray(array.name), nullptr) << array.name;
    EXPECT_EQ(data->GetArray(array.name)->GetDataType(), VTK_FLOAT);
    EXPECT_EQ(data->GetArray(array.name)->GetNumberOfComponents(), array.components);
    EXPECT_EQ(data->GetArray(array.name)->GetNumberOfTuples(),
      axis->GetOutput()->GetNumberOfPoints());
  }
  EXPECT_EQ(data->GetScalars(), data->GetArray("Radius"));
  EXPECT_EQ(axis->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST(MedialAxisFilter, CellsAreValid)
{
  auto axis = boxAxis();
  axis->Update();
  vtkPolyData* output = axis->GetOutput();
  EXPECT_GT(output->GetNumberOfPolys(), 100);
  EXPECT_EQ(output->GetNumberOfStrips(), 0);
  for (vtkCellArray* cells : { output->GetVerts(), output->GetLines(), output->GetPolys() })
  {
    if (cells->GetNumberOfConnectivityIds() > 0)
    {
      double range[2];
      cells->GetConnectivityArray()->GetRange(range);
      EXPECT_GE(range[0], 0.0);
      EXPECT_LT(range[1], static_cast<double>(output->GetNumberOfPoints()));
    }
  }
  vtkNew<vtkTriangleFilter> triangles; // a filter downstream can take it
  triangles->SetInputConnection(axis->GetOutputPort());
  triangles->Update();
  EXPECT_GT(triangles->GetOutput()->GetNumberOfPolys(), output->GetNumberOfPolys());
}

TEST(MedialAxisFilter, LargerAnglesKeepLess)
{
  auto axis = boxAxis(25);
  axis->SetAngle(60.0);
  axis->Update();
  const vtkIdType all = axis->GetOutput()->GetNumberOfCells();
  axis->SetAngle(120.0); // the sheets at the edges have 90 degrees
  axis->Update();
  vtkPolyData* output = axis->GetOutput();
  EXPECT_LT(output->GetNumberOfCells(), all / 2);
  EXPECT_GT(output->GetNumberOfCells(), 0);
  const std::vector<double> spacing = figures(axis->GetOutput(), "GridSpacing");
  ASSERT_EQ(spacing.size(), 3u);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(pointOf(output, i)[2], 0.0, spacing[0]) << "only the middle rectangle is left";
  }
}

TEST(MedialAxisFilter, SpheresCanBeLimited)
{
  auto axis = boxAxis(33);
  EXPECT_EQ(axis->GetMaximumNumberOfSpheres(), 0);
  axis->SetMaximumNumberOfSpheres(20);
  axis->Update();
  vtkPolyData* output = axis->GetOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), 20);
  EXPECT_GE(output->GetNumberOfPolys(), 20);
  for (const char* name :
    { "Radius", "SeparationAngle", "Lambda", "ClosestPointA", "ClosestPointB" })
  {
    ASSERT_NE(output->GetPointData()->GetArray(name), nullptr) << name;
    EXPECT_EQ(output->GetPointData()->GetArray(name)->GetNumberOfTuples(), 20) << name;
  }
  axis->SetMaximumNumberOfSpheres(0);
  axis->Update();
  EXPECT_GT(axis->GetOutput()->GetNumberOfPoints(), 1000);
}

TEST(MedialAxisFilter, RefusesAnglesAndEnumsOutsideTheirRange)
{
  auto axis = boxAxis(9);
  for (const double angle : { 0.0, -1.0, 180.0, 361.0, std::numeric_limits<double>::quiet_NaN() })
  {
    axis->SetAngle(angle);
    expectInvalidInput(axis, "angle");
  }
  axis->SetAngle(60.0);
  axis->SetSide(3);
  expectInvalidInput(axis, "Side 3");
  axis->SetSideToBoth();
  axis->SetRepresentation(-4);
  expectInvalidInput(axis, "Representation -4");
  axis->SetRepresentationToPoints();
  axis->SetMaximumNumberOfSpheres(-1);
  expectInvalidInput(axis, "-1 is outside [0, infinity)");
  axis->SetMaximumNumberOfSpheres(10);
  expectInvalidInput(axis, "surface or faces");
  axis->SetMaximumNumberOfSpheres(0);
  axis->SetTopology(2);
  expectInvalidInput(axis, "Topology 2");
  axis->SetTopologyToPreserve();
  expectInvalidInput(axis, "surface or faces");
  axis->SetTopologyToSelected();
  axis->Update();
  EXPECT_EQ(axis->GetErrorCode(), 0u);
}

TEST(MedialAxisFilter, PreservesTheTopology)
{
  // At 120 degrees only the middle rectangle of a box is left, in one piece.
  auto axis = boxAxis(25);
  axis->SetAngle(120.0);
  axis->SetTopologyToPreserve();
  EXPECT_STREQ(axis->GetTopologyAsString(), "Preserve");
  axis->Update();
  EXPECT_EQ(axis->GetErrorCode(), 0u);
  vtkNew<vtkConnectivityFilter> pieces;
  pieces->SetInputConnection(axis->GetOutputPort());
  pieces->SetExtractionModeToAllRegions();
  pieces->Update();
  EXPECT_EQ(pieces->GetNumberOfExtractedRegions(), 1);
  EXPECT_GT(axis->GetOutput()->GetNumberOfPolys(), 10);
}

TEST(MedialAxisFilter, SidesAreWhereTheySayTheyAre)
{
  // A lump is not convex, so it has axes on both sides.
  auto axis = axisOf(lumpPolyData(), 33);
  axis->SetPadding(0.2);
  const auto signs = [&](int side)
  {
    axis->SetSide(side);
    axis->GenerateDistanceFieldOn();
    axis->Update();
    for (const int port : { 0, 1 })
    {
      EXPECT_EQ(textFigure(axis->GetOutputDataObject(port), "Side"), axis->GetSideAsString());
    }
    std::array<int, 2> counts{};
    vtkImageData* field = axis->GetDistanceField();
    for (vtkIdType i = 0; i < axis->GetOutput()->GetNumberOfPoints(); ++i)
    {
      double x[3];
      axis->GetOutput()->GetPoint(i, x);
      const double distance = valueOf(field, "Distance", field->FindPoint(x));
      // Near the surface the nearest grid point may lie across it.
      if (std::abs(distance) > field->GetSpacing()[0])
      {
        ++counts[distance < 0.0 ? 0 : 1];
      }
    }
    return counts;
  };
  const auto interior = signs(vtkMedialAxis::INTERIOR);
  const auto exterior = signs(vtkMedialAxis::EXTERIOR);
  const auto both = signs(vtkMedialAxis::BOTH);
  EXPECT_GT(interior[0], 100);
  EXPECT_EQ(interior[1], 0);
  EXPECT_GT(exterior[1], 20);
  EXPECT_EQ(exterior[0], 0);
  EXPECT_NEAR(both[0] + both[1], interior[0] + interior[1] + exterior[0] + exterior[1],
    0.1 * (both[0] + both[1]));
}

TEST(MedialAxisFilter, OpenMeshHasBothSides)
{
  // Two plates, half of them the axis between.
  auto lower = squarePolyData();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (const double z : { -0.31, 0.31 })
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < 4; ++i)
    {
      const Point3 x = pointOf(lower, i);
      points->InsertNextPoint(x[0], x[1], z);
    }
    polys->InsertNextCell({ first, first + 1, first + 2, first + 3 });
  }
  vtkNew<vtkPolyData> plates;
  plates->SetPoints(points);
  plates->SetPolys(polys);
  auto axis = axisOf(plates, 26);
  axis->Update();
  EXPECT_EQ(textFigure(axis->GetOutput(), "SignMethod"), "None");
  EXPECT_EQ(axis->GetSide(), vtkMedialAxis::INTERIOR);
  EXPECT_EQ(textFigure(axis->GetOutput(), "Side"), "Both");
  vtkPolyData* output = axis->GetOutput();
  ASSERT_GT(output->GetNumberOfPoints(), 100);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(pointOf(output, i)[2], 0.0, 1e-3);
  }
}

TEST(MedialAxisFilter, RepresentationsShareTheAxis)
{
  auto axis = boxAxis(25);
  axis->SetRepresentationToPoints();
  axis->Update();
  const vtkIdType points = axis->GetOutput()->GetNumberOfPoints();
  EXPECT_EQ(axis->GetOutput()->GetNumberOfVerts(), points);
  EXPECT_EQ(axis->GetOutput()->GetNumberOfPolys(), 0);
  axis->SetRepresentationToFaces();
  axis->Update();
  // One voxel face for each crossing; points may coincide, and are welded then.
  const vtkIdType faces = axis->GetOutput()->GetNumberOfPolys();
  EXPECT_GE(faces, points);
  EXPECT_LE(faces, points + points / 50);
  axis->SetRepresentationToSurface();
  axis->Update();
  EXPECT_GT(axis->GetOutput()->GetNumberOfPolys(), points / 2);
  EXPECT_LE(axis->GetOutput()->GetNumberOfPolys(), faces);
}

} // namespace

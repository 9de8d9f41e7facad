#include "filter_support.h"

#include "medial/thickness.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCubeSource.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkMedialThickness.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#include <vtkTriangleFilter.h>
#include <vtkTrivialProducer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

using namespace medial::test;

vtkSmartPointer<vtkMedialThickness> make(vtkPolyData* mesh)
{
  auto filter = vtkSmartPointer<vtkMedialThickness>::New();
  filter->SetInputData(mesh);
  return filter;
}

/// The output of an algorithm, with points added inside its faces.
vtkSmartPointer<vtkPolyData> refined(vtkAlgorithm* algorithm)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(algorithm->GetOutputPort());
  vtkNew<vtkLinearSubdivisionFilter> fine;
  fine->SetInputConnection(triangles->GetOutputPort());
  fine->SetNumberOfSubdivisions(3);
  fine->Update();
  return fine->GetOutput();
}

/// A box of half sides 1, 0.8, 0.6 with points inside its faces.
vtkSmartPointer<vtkPolyData> fineBox()
{
  vtkNew<vtkTrivialProducer> box;
  box->SetOutput(boxPolyData());
  return refined(box);
}

double boxThickness(const medial::Point3& x)
{
  std::array<double, 3> gaps{ 1.0 - std::abs(x[0]), 0.8 - std::abs(x[1]), 0.6 - std::abs(x[2]) };
  const std::array<double, 3> halfSides{ 1.0, 0.8, 0.6 };
  const auto own = std::min_element(gaps.begin(), gaps.end());
  const double middle = halfSides[own - gaps.begin()];
  *own = middle;
  return 2.0 * *std::min_element(gaps.begin(), gaps.end());
}

void expectBoxThickness(vtkPolyData* output)
{
  ASSERT_GT(output->GetNumberOfPoints(), 100);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(valueOf(output, "Thickness", i), boxThickness(pointOf(output, i)), 1e-5);
  }
}

void expectError(const std::function<void(vtkMedialThickness*)>& spoil,
  const std::function<void(vtkMedialThickness*)>& repair, const std::string& words)
{
  auto filter = make(boxPolyData());
  expectErrorAndRecovery(
    filter, [&] { spoil(filter); }, [&] { repair(filter); }, words);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 8);
}

} // namespace

TEST(MedialThicknessFilter, DefaultsAreThoseOfTheLibrary)
{
  vtkNew<vtkMedialThickness> filter;
  const medial::ThicknessOptions options;
  EXPECT_EQ(filter->GetAngle(), options.angle);
  EXPECT_EQ(options.side, medial::Side::Interior);
  EXPECT_EQ(filter->GetSide(), vtkMedialThickness::INTERIOR);
  EXPECT_EQ(filter->GetNumberOfThreads(), options.execution.threads);
}

TEST(MedialThicknessFilter, OutputIsTheInputWithThickness)
{
  auto input = fineBox();
  vtkNew<vtkFloatArray> own;
  own->SetName("Own");
  own->SetNumberOfValues(input->GetNumberOfPoints());
  own->Fill(3.0);
  input->GetPointData()->AddArray(own);
  auto filter = make(input);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  expectBoxThickness(output);
  EXPECT_EQ(output->GetPoints(), input->GetPoints());
  EXPECT_EQ(output->GetNumberOfCells(), input->GetNumberOfCells());
  EXPECT_EQ(output->GetPointData()->GetArray("Own"), own);
  EXPECT_EQ(output->GetPointData()->GetArray("Thickness")->GetDataType(), VTK_FLOAT);
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Thickness");
  EXPECT_EQ(input->GetPointData()->GetArray("Thickness"), nullptr);
  EXPECT_EQ(figure(filter->GetOutput(), "MinThickness"), 0.0);
  EXPECT_NEAR(figure(filter->GetOutput(), "MaxThickness"), 1.2, 1e-6);
  EXPECT_GT(figure(filter->GetOutput(), "MedianThickness"), 0.0);
  EXPECT_EQ(figure(filter->GetOutput(), "Percentile5Thickness"), 0.0); // edges are many
  EXPECT_NEAR(figure(filter->GetOutput(), "Percentile95Thickness"), 1.2, 1e-6);
  EXPECT_EQ(figure(filter->GetOutput(), "ShareWithout"), 0.0);
}

TEST(MedialThicknessFilter, StripsAndUnjoinedPointsAreTheSameSurface)
{
  vtkNew<vtkStripper> strips;
  strips->SetInputData(fineBox());
  vtkNew<vtkMedialThickness> filter;
  filter->SetInputConnection(strips->GetOutputPort());
  filter->Update();
  ASSERT_GT(filter->GetOutput()->GetNumberOfStrips(), 0);
  expectBoxThickness(filter->GetOutput());

  vtkNew<vtkCubeSource> cube; // four points a face
  cube->SetBounds(-1.0, 1.0, -0.8, 0.8, -0.6, 0.6);
  filter->SetInputData(refined(cube));
  filter->Update();
  expectBoxThickness(filter->GetOutput());
}

TEST(MedialThicknessFilter, LinesAndVerticesHaveNone)
{
  auto filter = make(mixedPolyData());
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), mixedPolyData()->GetNumberOfPoints());
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (vtkCellArray* cells : { output->GetVerts(), output->GetLines() })
  {
    cells->GetCellAtId(0, count, ids);
    for (vtkIdType i = 0; i < count; ++i)
    {
      EXPECT_TRUE(std::isnan(valueOf(output, "Thickness", ids[i])));
    }
  }
}

TEST(MedialThicknessFilter, PointsOfNoCellHaveNone)
{
  auto box = boxPolyData();
  box->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  auto filter = make(box);
  filter->Update();
  EXPECT_TRUE(std::isnan(valueOf(filter->GetOutput(), "Thickness", 8)));
  EXPECT_EQ(valueOf(filter->GetOutput(), "Thickness", 0), 0.0);
  EXPECT_EQ(figure(filter->GetOutput(), "ShareWithout"), 0.0);
}

TEST(MedialThicknessFilter, SideAndAngleArePassedOn)
{
  auto filter = make(fineBox());
  filter->SetSideToExterior();
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "ShareWithout"), 1.0);
  EXPECT_TRUE(std::isnan(figure(filter->GetOutput(), "MedianThickness")));
  filter->SetSideToBoth();
  filter->Update();
  expectBoxThickness(filter->GetOutput());
  filter->SetSideToInterior();
  filter->SetAngle(120.0);
  filter->Update();
  EXPECT_GT(figure(filter->GetOutput(), "MinThickness"), 0.0);
  EXPECT_GT(figure(filter->GetOutput(), "ShareWithout"), 0.0); // beside the edges
}

TEST(MedialThicknessFilter, ExecutesWhenSomethingChangedAndDoesNotModifyItself)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkMedialThickness> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  EventLog log(filter);
  filter->Update();
  const vtkMTimeType time = filter->GetMTime();
  filter->Update();
  EXPECT_EQ(log.executions, 1);
  const double small = figure(filter->GetOutput(), "MedianThickness");
  sphere->SetRadius(5.0);
  filter->Update();
  EXPECT_EQ(log.executions, 2);
  EXPECT_NEAR(figure(filter->GetOutput(), "MedianThickness"), 10.0 * small, 1e-3);
  EXPECT_EQ(filter->GetMTime(), time);
}

TEST(MedialThicknessFilter, MethodsAreThoseOfTheLibrary)
{
  auto filter = make(fineBox());
  filter->SetMethodToRay();
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "MinThickness"), 1.2, 1e-5);
  EXPECT_NEAR(figure(filter->GetOutput(), "MaxThickness"), 2.0, 1e-5);
  filter->SetMethodToWall();
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "MinThickness"), 1.2, 1e-5);
  EXPECT_STREQ(filter->GetMethodAsString(), "Wall");
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("Thickness"), nullptr);
}

TEST(MedialThicknessFilter, CellsHaveValues)
{
  auto filter = make(boxPolyData());
  filter->SetMethodToWall();
  filter->CellValuesOn();
  filter->Update();
  vtkDataArray* values = filter->GetOutput()->GetCellData()->GetArray("Thickness");
  ASSERT_NE(values, nullptr);
  EXPECT_EQ(values->GetNumberOfTuples(), filter->GetOutput()->GetNumberOfCells());
  EXPECT_NEAR(values->GetRange()[0], 1.2, 1e-5);
}

// Data arrays of the input are passed on to the divided surface.
TEST(MedialThicknessFilter, DividesLargeTriangles)
{
  auto box = boxPolyData();
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(box->GetPoint(i)[2]);
  }
  box->GetPointData()->AddArray(heights);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < box->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i));
  }
  box->GetCellData()->AddArray(numbers);
  auto filter = make(box);
  filter->SetMaximumEdgeLength(0.2);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  expectBoxThickness(output);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(valueOf(output, "Height", i), output->GetPoint(i)[2], 1e-12);
  }
  vtkDataArray* cells = output->GetCellData()->GetArray("InputCell");
  vtkDataArray* copies = output->GetCellData()->GetArray("Number");
  ASSERT_EQ(cells->GetNumberOfTuples(), output->GetNumberOfCells());
  ASSERT_EQ(copies->GetNumberOfTuples(), output->GetNumberOfCells());
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    ASSERT_EQ(cells->GetTuple1(i), copies->GetTuple1(i));
  }
}

TEST(MedialThicknessFilter, FindsRegionsBeyondLimits)
{
  auto filter = make(boxPolyData());
  filter->SetMethodToWall();
  filter->SetMaximumEdgeLength(0.2);
  filter->SetMinimumThickness(1.3);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetCellData()->GetArray("Region")->GetRange()[0], 1.0);
  EXPECT_EQ(figure(output, "RegionThin"), 1.0);
  EXPECT_NEAR(figure(output, "RegionValue"), 1.2, 1e-5);
  EXPECT_NEAR(figure(output, "RegionArea"), 8.0 * (0.8 + 0.6 + 0.48), 1e-5);
  filter->SetMinimumThickness(1.1);
  filter->Update();
  EXPECT_EQ(output->GetCellData()->GetArray("Region")->GetRange()[1], 0.0);
  EXPECT_EQ(output->GetFieldData()->GetArray("RegionValue")->GetNumberOfTuples(), 0);
}

TEST(MedialThicknessFilter, RefusesLimitsThatContradictEachOther)
{
  using F = vtkMedialThickness*;
  const auto repair = [](F f)
  {
    f->SetMethodToBall();
    f->SetMinimumThickness(0.0);
    f->SetMaximumThickness(0.0);
    f->SetMaximumEdgeLength(0.0);
  };
  expectError(
    [](F f)
    {
      f->SetMinimumThickness(2.0);
      f->SetMaximumThickness(1.0);
    },
    repair, "minimum thickness 2 is not below maximum thickness 1");
  expectError([](F f) { f->SetMinimumThickness(-1.0); }, repair, "minimum thickness -1");
  expectError([](F f) { f->SetMaximumEdgeLength(-1.0); }, repair, "maximum edge length -1");
  expectError([](F f) { f->SetMethod(3); }, repair,
    "Method 3 is not one of 0 (ball), 1 (ray), 2 (wall)");
  auto open = boxPolyData();
  open->GetPolys()->Initialize();
  open->GetPolys()->InsertNextCell({ 0, 1, 3 });
  auto filter = make(open);
  filter->SetMinimumThickness(1.0);
  EventLog log(filter);
  filter->Update();
  EXPECT_NE(filter->GetErrorCode(), 0U);
}

TEST(MedialThicknessFilter, RefusesParametersOutsideTheirRange)
{
  using F = vtkMedialThickness*;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto repairAngle = [](F f) { f->SetAngle(60.0); };
  expectError([](F f) { f->SetAngle(0.0); }, repairAngle, "angle 0 is outside (0, 180)");
  expectError([](F f) { f->SetAngle(180.0); }, repairAngle, "angle 180 is outside");
  expectError([=](F f) { f->SetAngle(nan); }, repairAngle, "nan");
  expectError([](F f) { f->SetSide(3); }, [](F f) { f->SetSide(0); }, "Side 3");
  expectError([](F f) { f->SetNumberOfThreads(-1); }, [](F f) { f->SetNumberOfThreads(1); },
    "NumberOfThreads -1");
}

TEST(MedialThicknessFilter, RefusesUnusableInput)
{
  const auto repair = [](vtkMedialThickness* f) {
    f->SetInputData(boxPolyData({ 1.0, 1.0, 1.0 }));
  };
  const auto with = [](const std::function<void(vtkPolyData*)>& spoil)
  { return [spoil](vtkMedialThickness* f) { f->SetInputData(spoiledBox(spoil)); }; };
  expectError(with([](vtkPolyData* box) { box->Initialize(); }), repair, "no cells");
  expectError(with([](vtkPolyData* box) { box->GetPoints()->SetPoint(3, HUGE_VAL, 0.0, 0.0); }),
    repair, "point 3");
}

TEST(MedialThicknessFilter, ReportsProgress)
{
  auto filter = make(lumpPolyData());
  EventLog log(filter);
  filter->Update();
  expectProgressToTheEnd(log);
}

TEST(MedialThicknessFilter, AbortLeavesNothingAndTheNextUpdateExecutesAgain)
{
  expectAbortLeavesNothing(make(lumpPolyData()), 1);
}

TEST(MedialThicknessFilter, PieceZeroIsAllOfIt)
{
  auto filter = make(fineBox());
  filter->UpdatePiece(1, 3, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->UpdatePiece(0, 3, 0);
  expectBoxThickness(filter->GetOutput());
}

#include "filter_support.h"

#include "medial/medial/thickness.h"

#include <gtest/gtest.h>

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkElevationFilter.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkMedialThickness.h>
#include <vtkMeshFieldAlgorithm.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStripper.h>
#include <vtkTriangleFilter.h>

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

bool update(vtkMedialThickness* filter)
{
  return filter->GetExecutive()->Update() != 0;
}

/// A box of half sides 1, 0.8, 0.6 with points inside its faces.
vtkSmartPointer<vtkPolyData> fineBox()
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(boxPolyData({ 1.0, 0.8, 0.6 }));
  vtkNew<vtkLinearSubdivisionFilter> fine;
  fine->SetInputConnection(triangles->GetOutputPort());
  fine->SetNumberOfSubdivisions(3);
  fine->Update();
  return fine->GetOutput();
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
  auto filter = make(boxPolyData({ 1.0, 0.8, 0.6 }));
  ASSERT_TRUE(update(filter)) << words;
  EventLog log(filter);
  spoil(filter);
  EXPECT_FALSE(update(filter)) << words;
  ASSERT_EQ(log.errors.size(), 1u) << words;
  EXPECT_NE(log.errors[0].find(words), std::string::npos) << log.errors[0];
  EXPECT_EQ(filter->GetErrorCode(),
    static_cast<unsigned long>(vtkMeshFieldAlgorithm::InvalidInputError));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetGreatestThickness(), 0.0);
  repair(filter);
  EXPECT_TRUE(update(filter)) << words;
  EXPECT_EQ(filter->GetErrorCode(), 0u);
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
  EXPECT_EQ(filter->GetNumberOfThreads(), options.threads);
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
  EXPECT_EQ(filter->GetLeastThickness(), 0.0);
  EXPECT_NEAR(filter->GetGreatestThickness(), 1.2, 1e-6);
  EXPECT_GT(filter->GetMedianThickness(), 0.0);
  EXPECT_EQ(filter->GetShareWithout(), 0.0);
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
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkLinearSubdivisionFilter> fine;
  fine->SetInputConnection(triangles->GetOutputPort());
  fine->SetNumberOfSubdivisions(3);
  filter->SetInputConnection(fine->GetOutputPort());
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
  auto box = boxPolyData({ 1.0, 0.8, 0.6 });
  box->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  auto filter = make(box);
  filter->Update();
  EXPECT_TRUE(std::isnan(valueOf(filter->GetOutput(), "Thickness", 8)));
  EXPECT_EQ(valueOf(filter->GetOutput(), "Thickness", 0), 0.0);
  EXPECT_EQ(filter->GetShareWithout(), 0.0);
}

TEST(MedialThicknessFilter, SideAndAngleArePassedOn)
{
  auto filter = make(fineBox());
  filter->SetSideToExterior();
  filter->Update();
  EXPECT_EQ(filter->GetShareWithout(), 1.0);
  EXPECT_TRUE(std::isnan(filter->GetMedianThickness()));
  filter->SetSideToBoth();
  filter->Update();
  expectBoxThickness(filter->GetOutput());
  filter->SetSideToInterior();
  filter->SetAngle(120.0);
  filter->Update();
  EXPECT_GT(filter->GetLeastThickness(), 0.0);
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
  const double small = filter->GetMedianThickness();
  sphere->SetRadius(5.0);
  filter->Update();
  EXPECT_EQ(log.executions, 2);
  EXPECT_NEAR(filter->GetMedianThickness(), 10.0 * small, 1e-3);
  EXPECT_EQ(filter->GetMTime(), time);
}

TEST(MedialThicknessFilter, RefusesParametersOutsideTheirRange)
{
  using F = vtkMedialThickness*;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto repairAngle = [](F f) { f->SetAngle(60.0); };
  expectError([](F f) { f->SetAngle(0.0); }, repairAngle, "angle 0.000000 is outside (0, 180)");
  expectError([](F f) { f->SetAngle(180.0); }, repairAngle, "180.0");
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
  {
    return [spoil](vtkMedialThickness* f)
    {
      auto box = boxPolyData({ 1.0, 0.8, 0.6 });
      spoil(box);
      f->SetInputData(box);
    };
  };
  expectError(with([](vtkPolyData* box) { box->Initialize(); }), repair, "no cells");
  expectError(with([](vtkPolyData* box) { box->GetPoints()->SetPoint(3, HUGE_VAL, 0.0, 0.0); }),
    repair, "point 3");
}

TEST(MedialThicknessFilter, ReportsProgress)
{
  auto filter = make(lumpPolyData());
  EventLog log(filter);
  filter->Update();
  ASSERT_GE(log.progress.size(), 3u);
  EXPECT_TRUE(std::is_sorted(log.progress.begin(), log.progress.end()));
  EXPECT_EQ(log.progress.front(), 0.0);
  EXPECT_EQ(log.progress.back(), 1.0);
}

TEST(MedialThicknessFilter, AbortLeavesNothingAndTheNextUpdateExecutesAgain)
{
  auto filter = make(lumpPolyData());
  vtkNew<vtkElevationFilter> downstream;
  downstream->SetInputConnection(filter->GetOutputPort());
  EventLog after(downstream);
  {
    EventLog log(filter);
    log.abortAtProgress = 1;
    downstream->Update();
    EXPECT_EQ(log.executions, 1);
    EXPECT_TRUE(log.errors.empty());
    EXPECT_EQ(after.executions, 0);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetErrorCode(),
      static_cast<unsigned long>(vtkMeshFieldAlgorithm::CancelledError));
  }
  downstream->Update();
  EXPECT_EQ(after.executions, 1);
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(MedialThicknessFilter, PieceZeroIsAllOfIt)
{
  auto filter = make(fineBox());
  filter->UpdatePiece(1, 3, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->UpdatePiece(0, 3, 0);
  expectBoxThickness(filter->GetOutput());
}

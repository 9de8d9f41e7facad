#include "filter_support.h"

#include "medial/point_distance.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMeshPointDistance.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSource.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace medial::test;

const medial::Point3 kHalfSides{ 1.0, 0.8, 0.6 };

/// Random points around the box, with no cells.
vtkSmartPointer<vtkPolyData> cloud(int count = 400)
{
  vtkNew<vtkPointSource> source;
  source->SetNumberOfPoints(count);
  source->SetRadius(2.0);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkMeshPointDistance> make(vtkDataObject* points, vtkPolyData* surface)
{
  auto filter = vtkSmartPointer<vtkMeshPointDistance>::New();
  filter->SetInputDataObject(points);
  filter->SetSurfaceData(surface);
  return filter;
}

void expectBoxDistances(vtkDataSet* output)
{
  ASSERT_GT(output->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const medial::Point3 x = pointOf(output, i);
    const double distance = valueOf(output, "Distance", i);
    ASSERT_NEAR(distance, boxDistance(kHalfSides, x), 1e-12);
    const medial::Point3 closest = vectorOf(output, "ClosestPoint", i);
    ASSERT_NEAR(distanceBetween(closest, x), std::abs(distance), 1e-12);
    const auto cell = static_cast<vtkIdType>(valueOf(output, "ClosestCell", i));
    ASSERT_NEAR(distanceToCell(boxPolyData(), cell, closest), 0.0, 1e-6); // VTK's own accuracy
    const medial::Point3 direction = vectorOf(output, "Direction", i);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(x[axis] + std::abs(distance) * direction[axis], closest[axis], 1e-12);
    }
  }
}

void expectError(const std::function<void(vtkMeshPointDistance*)>& spoil,
  const std::function<void(vtkMeshPointDistance*)>& repair, const std::string& words)
{
  auto filter = make(cloud(), boxPolyData());
  expectErrorAndRecovery(
    filter, [&] { spoil(filter); }, [&] { repair(filter); }, words);
}

} // namespace

TEST(MeshPointDistanceFilter, OutputIsTheInputWithDistances)
{
  auto input = cloud();
  vtkNew<vtkDoubleArray> own;
  own->SetName("Own");
  own->SetNumberOfValues(input->GetNumberOfPoints());
  own->Fill(7.0);
  input->GetPointData()->AddArray(own);
  auto filter = make(input, boxPolyData());
  filter->Update();
  vtkDataSet* output = filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), 400);
  EXPECT_EQ(valueOf(output, "Own", 3), 7.0);
  expectBoxDistances(output);
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Distance");
  EXPECT_EQ(output->GetPointData()->GetArray("Distance")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(input->GetPointData()->GetArray("Distance"), nullptr);
  EXPECT_EQ(textFigure(output, "SignMethod"), "Winding");
  EXPECT_EQ(textFigure(output, "SignReason"), "the mesh is closed");
}

TEST(MeshPointDistanceFilter, SummarisesThePoints)
{
  auto filter = make(cloud(), boxPolyData());
  filter->Update();
  vtkDataSet* output = filter->GetOutput();
  double min = HUGE_VAL;
  double max = -HUGE_VAL;
  double sum = 0.0;
  double squares = 0.0;
  std::vector<double> magnitudes;
  for (vtkIdType i = 0; i < 400; ++i)
  {
    const double distance = boxDistance(kHalfSides, pointOf(output, i));
    min = std::min(min, distance);
    max = std::max(max, distance);
    sum += std::abs(distance);
    squares += distance * distance;
    magnitudes.push_back(std::abs(distance));
  }
  EXPECT_NEAR(figure(output, "MinDistance"), min, 1e-12);
  EXPECT_NEAR(figure(output, "MaxDistance"), max, 1e-12);
  EXPECT_NEAR(figure(output, "MeanDistance"), sum / 400.0, 1e-12);
  EXPECT_NEAR(figure(output, "RMSDistance"), std::sqrt(squares / 400.0), 1e-12);
  std::sort(magnitudes.begin(), magnitudes.end());
  EXPECT_NEAR(figure(output, "MedianDistance"), magnitudes[199], 1e-12);
  EXPECT_NEAR(figure(output, "Percentile95Distance"), magnitudes[379], 1e-12);
}

TEST(MeshPointDistanceFilter, TakesThePointsOfAnyDataSet)
{
  vtkNew<vtkImageData> image;
  image->SetOrigin(-1.3, -1.2, -1.1);
  image->SetSpacing(0.31, 0.27, 0.23);
  image->SetDimensions(9, 9, 9);
  auto filter = make(image, boxPolyData());
  filter->Update();
  ASSERT_NE(vtkImageData::SafeDownCast(filter->GetOutput()), nullptr);
  expectBoxDistances(filter->GetOutput());

  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(cloud()->GetPoints());
  filter->SetInputDataObject(grid);
  filter->Update();
  ASSERT_NE(vtkUnstructuredGrid::SafeDownCast(filter->GetOutput()), nullptr);
  expectBoxDistances(filter->GetOutput());
}

TEST(MeshPointDistanceFilter, ComputesEachBlockOfACompositeInput)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud(30));
  blocks->SetBlock(1, cloud(20));
  auto filter = make(blocks, boxPolyData());
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  for (unsigned block = 0; block < 2; ++block)
  {
    expectBoxDistances(vtkDataSet::SafeDownCast(output->GetBlock(block)));
  }
}

TEST(MeshPointDistanceFilter, SignMethodIsPassedOn)
{
  auto filter = make(cloud(), boxPolyData());
  filter->SetSignMethodToNone();
  filter->Update();
  EXPECT_GE(figure(filter->GetOutput(), "MinDistance"), 0.0);
  EXPECT_EQ(textFigure(filter->GetOutput(), "SignMethod"), "None");
  filter->SetSurfaceData(squarePolyData());
  filter->SetSignMethodToPseudonormal();
  expectInvalidInput(filter, "pseudonormal needs a closed");
}

TEST(MeshPointDistanceFilter, PointsWithoutCellsAndNoPointsAreFine)
{
  auto filter = make(vtkSmartPointer<vtkPolyData>::New(), boxPolyData());
  EXPECT_TRUE(update(filter));
  EXPECT_TRUE(std::isnan(figure(filter->GetOutput(), "MeanDistance")));
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("Distance"), nullptr);
}

TEST(MeshPointDistanceFilter, ExecutesWhenPointsOrSurfaceChange)
{
  auto input = cloud();
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkMeshPointDistance> filter;
  filter->SetInputDataObject(input);
  filter->SetSurfaceConnection(sphere->GetOutputPort());
  EventLog log(filter);
  filter->Update();
  filter->Update();
  EXPECT_EQ(log.executions, 1);
  const double before = figure(filter->GetOutput(), "MaxDistance");
  sphere->SetRadius(1.5);
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "MaxDistance"), before - 1.0, 0.1);
  input->GetPoints()->SetPoint(0, 100.0, 0.0, 0.0);
  input->GetPoints()->Modified();
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "MaxDistance"), 98.5, 0.05);
  EXPECT_EQ(log.executions, 3);
}

TEST(MeshPointDistanceFilter, RefusesUnusableInput)
{
  using F = vtkMeshPointDistance*;
  expectError([](F f) { f->SetNumberOfThreads(-1); }, [](F f) { f->SetNumberOfThreads(0); },
    "NumberOfThreads -1");
  expectError([](F f) { f->SetSignMethod(9); }, [](F f) { f->SetSignMethodToAuto(); },
    "SignMethod 9");
  expectError([](F f) { f->SetSurfaceData(vtkSmartPointer<vtkPolyData>::New()); },
    [](F f) { f->SetSurfaceData(boxPolyData()); }, "no cells");
  expectError(
    [](F f)
    {
      auto points = cloud();
      points->GetPoints()->SetPoint(5, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
      f->SetInputDataObject(points);
    },
    [](F f) { f->SetInputDataObject(cloud()); }, "point 5");
}

TEST(MeshPointDistanceFilter, ReportsProgressAndStopsWhenAsked)
{
  {
    auto filter = make(cloud(), boxPolyData());
    EventLog log(filter);
    filter->Update();
    EXPECT_EQ(log.progress.back(), 1.0);
  }
  expectAbortLeavesNothing(make(cloud(), boxPolyData()), 1);
}

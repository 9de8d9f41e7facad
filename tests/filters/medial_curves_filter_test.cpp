// vtkMedialCurves: what a pipeline may expect of it. Its curves are tested beside those of a box in
// medial_axis_filter_test.cpp and in the tests of the library.
#include "filter_support.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMedialCurves.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace
{

using namespace medial::test;

/// Squares side by side without common points: each has a rim of its own.
vtkSmartPointer<vtkPolyData> separateSquares(int count)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType first = points->InsertNextPoint(2.0 * i, 0.0, 0.0);
    points->InsertNextPoint(2.0 * i + 1.0, 0.0, 0.0);
    points->InsertNextPoint(2.0 * i + 1.0, 1.0, 0.0);
    points->InsertNextPoint(2.0 * i, 1.0, 0.0);
    polys->InsertNextCell({ first, first + 1, first + 2, first + 3 });
  }
  auto squares = vtkSmartPointer<vtkPolyData>::New();
  squares->SetPoints(points);
  squares->SetPolys(polys);
  return squares;
}

vtkSmartPointer<vtkMedialCurves> make(vtkPolyData* axis)
{
  auto filter = vtkSmartPointer<vtkMedialCurves>::New();
  filter->SetInputData(axis);
  return filter;
}

void expectError(const std::function<void(vtkPolyData*)>& spoil, const std::string& words)
{
  auto filter = make(squarePolyData());
  auto spoiled = squarePolyData();
  spoil(spoiled);
  expectErrorAndRecovery(
    filter, [&] { filter->SetInputData(spoiled); },
    [&] { filter->SetInputData(separateSquares(2)); }, words);
}

TEST(MedialCurvesFilter, ASquareHasARim)
{
  auto filter = make(squarePolyData());
  EXPECT_TRUE(update(filter));
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(output->GetNumberOfPoints(), 4);
  ASSERT_NE(output->GetCellData()->GetArray("AxisFeature"), nullptr);
  EXPECT_EQ(output->GetCellData()->GetArray("AxisFeature")->GetTuple1(0), 1.0);
}

TEST(MedialCurvesFilter, RefusesCellsOfMissingPoints)
{
  expectError([](vtkPolyData* mesh) { mesh->GetPoints()->SetNumberOfPoints(3); },
    "names the point 3, but there are 3");
  expectError([](vtkPolyData* mesh) { mesh->GetPoints()->SetNumberOfPoints(0); },
    "names the point 0, but there are 0");
  expectError(
    [](vtkPolyData* mesh)
    {
      vtkNew<vtkCellArray> lines;
      lines->InsertNextCell({ 0, -1 });
      mesh->SetLines(lines);
    },
    "names the point -1");
}

TEST(MedialCurvesFilter, AnEmptyAxisHasNoCurves)
{
  vtkNew<vtkPolyData> empty;
  auto filter = make(empty);
  EventLog log(filter);
  EXPECT_TRUE(update(filter));
  EXPECT_TRUE(log.errors.empty());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MedialCurvesFilter, SecondUpdateDoesNothingAndParametersExecuteAgain)
{
  auto filter = make(squarePolyData());
  EventLog log(filter);
  const vtkMTimeType time = filter->GetMTime();
  filter->Update();
  filter->Update();
  EXPECT_EQ(log.executions, 1);
  EXPECT_EQ(filter->GetMTime(), time);
  filter->RimsOff();
  filter->Update();
  EXPECT_EQ(log.executions, 2);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MedialCurvesFilter, ReportsProgress)
{
  auto filter = make(separateSquares(100));
  EventLog log(filter);
  filter->Update();
  expectProgressToTheEnd(log);
  EXPECT_FALSE(log.phases[1].empty());
}

TEST(MedialCurvesFilter, AbortLeavesNothingAndTheNextUpdateExecutesAgain)
{
  std::size_t events = 0;
  {
    auto filter = make(separateSquares(100));
    EventLog log(filter);
    filter->Update();
    events = log.progress.size();
  }
  ASSERT_GE(events, 6u);
  for (std::size_t i = 0; i + 1 < events; ++i)
  {
    expectAbortLeavesNothing(make(separateSquares(100)), i);
  }
}

TEST(MedialCurvesFilter, PieceZeroIsAllOfIt)
{
  auto filter = make(separateSquares(3));
  filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->UpdatePiece(0, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 3);
}

} // namespace

#include "filter_support.h"

#include "medial/compute_medial_axis.h"
#include "medial/skeleton.h"
#include "medial/skeleton_resolution.h"

#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMedialSkeleton.h>
#include <vtkMeshFieldAlgorithm.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace medial::test;

vtkSmartPointer<vtkMedialSkeleton> make(vtkPolyData* mesh)
{
  auto filter = vtkSmartPointer<vtkMedialSkeleton>::New();
  filter->SetInputData(mesh);
  filter->SetResolution(64);
  return filter;
}

vtkSmartPointer<vtkPolyData> beam()
{
  return boxPolyData({ 2.0, 0.25, 0.25 });
}

} // namespace

TEST(MedialSkeletonFilter, DefaultsAreThoseOfTheLibrary)
{
  vtkNew<vtkMedialSkeleton> filter;
  const medial::SkeletonOptions options;
  EXPECT_EQ(filter->GetMinimumBranch(), options.minBranch);
  EXPECT_EQ(filter->GetSmooth() != 0, options.smooth);
  EXPECT_EQ(filter->GetAngle(), medial::MedialAxisOptions{}.angle);
  EXPECT_EQ(filter->GetMinimumLambda(), 0.0);
  EXPECT_EQ(filter->GetAutomaticResolution(), 0);
}

TEST(MedialSkeletonFilter, ABeamHasOneBranch)
{
  auto filter = make(beam());
  ASSERT_TRUE(update(filter));
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfCells(), 1);
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(output->GetCell(0)->GetNumberOfPoints(), output->GetNumberOfPoints());
  EXPECT_NEAR(output->GetCellData()->GetArray("Length")->GetTuple1(0), 3.5, 0.035);
  EXPECT_EQ(output->GetCellData()->GetArray("Kind")->GetTuple1(0), 3.0);
  EXPECT_EQ(output->GetCellData()->GetArray("BranchId")->GetTuple1(0), 0.0);
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Radius");
  EXPECT_EQ(output->GetPointData()->GetScalars()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(valueOf(output, "Radius", i), -boxDistance({ 2.0, 0.25, 0.25 }, pointOf(output, i)),
      1e-9);
    EXPECT_NEAR(std::abs(vectorOf(output, "Tangent", i)[0]), 1.0, 1e-3);
  }
  EXPECT_EQ(figure(output, "Branches"), 1.0);
  EXPECT_EQ(figure(output, "Junctions"), 0.0);
  EXPECT_EQ(figure(output, "Components"), 1.0);
  EXPECT_EQ(figure(output, "Loops"), 0.0);
  EXPECT_EQ(textFigure(output, "SignMethod"), "Winding");
}

TEST(MedialSkeletonFilter, ACubeShrinksToAVertex)
{
  auto filter = make(boxPolyData({ 1.0, 1.0, 1.0 }));
  ASSERT_TRUE(update(filter));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfVerts(), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_EQ(valueOf(filter->GetOutput(), "Degree", 0), 0.0);
}

TEST(MedialSkeletonFilter, TheThinnestBranchChoosesTheResolution)
{
  const auto pointsAlong = [](vtkMedialSkeleton* filter)
  {
    EXPECT_TRUE(update(filter));
    return filter->GetOutput()->GetFieldData()->GetArray("GridDimensions")->GetTuple(0)[0];
  };
  auto filter = make(boxPolyData({ 2.0, 0.04, 0.04 }));
  filter->AutomaticResolutionOn();
  const double chosen = pointsAlong(filter);
  EXPECT_GT(chosen, medial::kMinSkeletonResolution);
  EXPECT_LT(chosen, medial::kMaxSkeletonResolution);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 1);
  filter->SetInputData(beam());
  EXPECT_EQ(pointsAlong(filter), medial::kMinSkeletonResolution);
  filter->SetGridModeToSpacing();
  filter->SetSpacing(0.1, 0.1, 0.1);
  EXPECT_LT(pointsAlong(filter), 64); // as the spacing says
  filter->AutomaticResolutionOff();
  filter->SetGridModeToResolution();
  EXPECT_EQ(pointsAlong(filter), 64);
}

TEST(MedialSkeletonFilter, WarnsWhereTheChosenResolutionIsNotEnough)
{
  auto filter = make(boxPolyData({ 2.0, 0.012, 0.012 }));
  filter->AutomaticResolutionOn();
  const EventLog log(filter);
  ASSERT_TRUE(update(filter));
  ASSERT_EQ(log.warnings.size(), 1u);
  EXPECT_NE(log.warnings.front().find("AutomaticResolution takes at most 512"), std::string::npos)
    << log.warnings.front();
}

TEST(MedialSkeletonFilter, RefusesBadParametersAndMeshesWithoutAnInside)
{
  auto filter = make(beam());
  expectErrorAndRecovery(
    filter, [&] { filter->SetMinimumBranch(-1.0); }, [&] { filter->SetMinimumBranch(1.0); },
    "minimum branch length -1 is outside [0, infinity)");
  expectErrorAndRecovery(
    filter, [&] { filter->SetAngle(180.0); }, [&] { filter->SetAngle(60.0); }, "180");
  expectErrorAndRecovery(
    filter, [&] { filter->SetNumberOfThreads(-2); }, [&] { filter->SetNumberOfThreads(0); }, "-2");
  expectInvalidInput(make(squarePolyData()), "a skeleton needs to know inside from outside");
}

TEST(MedialSkeletonFilter, ReportsProgressAndCanBeAborted)
{
  auto filter = make(beam());
  {
    const EventLog log(filter);
    ASSERT_TRUE(update(filter));
    expectProgressToTheEnd(log);
  }
  filter->Modified();
  expectAbortLeavesNothing(filter, 3);
}

TEST(MedialSkeletonFilter, OnlyTheFirstPieceHasOutput)
{
  auto filter = make(beam());
  filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->UpdatePiece(0, 2, 0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 10);
}

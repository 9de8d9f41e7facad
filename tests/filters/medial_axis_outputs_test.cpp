// vtkMedialAxis: do its two outputs behave?
#include "box_axis.h"

#include <gtest/gtest.h>

#include <vtkContourFilter.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMeshDistanceField.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTriangleFilter.h>

namespace
{

using namespace medial::test;

TEST(MedialAxisOutputs, DistanceFieldIsEmptyUnlessEnabled)
{
  auto axis = boxAxis(13);
  axis->Update();
  EXPECT_GT(axis->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(isEmpty(axis->GetDistanceField()));
  axis->Update(1);
  EXPECT_TRUE(isEmpty(axis->GetDistanceField()));
  int whole[6];
  axis->GetOutputInformation(1)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  EXPECT_LT(whole[1], whole[0]);
}

TEST(MedialAxisOutputs, WithoutTheFieldTheInputIsNotUpdatedForInformation)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkMedialAxis> axis;
  axis->SetInputConnection(sphere->GetOutputPort());
  EventLog log(sphere);
  axis->UpdateInformation();
  EXPECT_EQ(log.executions, 0);
}

TEST(MedialAxisOutputs, DistanceFieldIsThatOfTheOtherFilter)
{
  auto axis = boxAxis(19);
  axis->GenerateDistanceFieldOn();
  axis->GenerateClosestFeatureOff();
  axis->UpdateInformation();
  int whole[6];
  axis->GetOutputInformation(1)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  EXPECT_EQ(whole[1], 18);
  EventLog log(axis);
  axis->Update();
  vtkNew<vtkMeshDistanceField> reference;
  reference->SetInputData(boxPolyData(kHalfSides));
  reference->SetPadding(0.0637);
  reference->SetResolution(19);
  reference->Update();
  vtkImageData* field = axis->GetDistanceField();
  ASSERT_EQ(field->GetNumberOfPoints(), reference->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(field->GetPointData()->GetNumberOfArrays(), 4);
  EXPECT_EQ(field->GetPointData()->GetArray("ClosestFeature"), nullptr);
  const double h = field->GetSpacing()[0];
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(pointOf(field, i), pointOf(reference->GetOutput(), i));
    ASSERT_NEAR(valueOf(field, "Distance", i), valueOf(reference->GetOutput(), "Distance", i),
      1e-3 * h);
    ASSERT_NEAR(valueOf(field, "Distance", i), boxDistance(kHalfSides, pointOf(field, i)),
      1e-2 * h);
  }
  EXPECT_EQ(log.executions, 1);
}

TEST(MedialAxisOutputs, OneExecutionServesBothPorts)
{
  for (const int first : { 0, 1 })
  {
    auto axis = boxAxis(13);
    axis->GenerateDistanceFieldOn();
    EventLog log(axis);
    axis->Update(first);
    EXPECT_GT(axis->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(axis->GetDistanceField()->GetDimensions()[0], 13);
    axis->Update(1 - first);
    EXPECT_EQ(log.executions, 1);
    EXPECT_GT(axis->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(axis->GetDistanceField()->GetDimensions()[0], 13);
  }
}

TEST(MedialAxisOutputs, TheFieldComesAndGoesWithItsSwitch)
{
  auto axis = boxAxis(13);
  axis->Update();
  axis->GenerateDistanceFieldOn();
  axis->Update();
  EXPECT_EQ(axis->GetDistanceField()->GetDimensions()[0], 13);
  axis->SetResolution(9);
  axis->Update();
  EXPECT_EQ(axis->GetDistanceField()->GetDimensions()[0], 9);
  axis->GenerateDistanceFieldOff();
  EventLog log(axis);
  axis->Update();
  axis->Update(1);
  EXPECT_TRUE(isEmpty(axis->GetDistanceField()));
  EXPECT_EQ(log.pipelineErrors, 0);
}

TEST(MedialAxisOutputs, BothFeedPipelines)
{
  auto axis = boxAxis(21);
  axis->GenerateDistanceFieldOn();
  EventLog log(axis);
  vtkNew<vtkContourFilter> surface;
  surface->SetInputConnection(axis->GetOutputPort(1));
  surface->SetValue(0, -0.1);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(axis->GetOutputPort(0));
  surface->Update();
  triangles->Update();
  EXPECT_GT(surface->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_GT(triangles->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(log.executions, 1);
}

TEST(MedialAxisOutputs, AFailedExecutionEmptiesBoth)
{
  auto axis = boxAxis(13);
  axis->GenerateDistanceFieldOn();
  axis->Update();
  EventLog log(axis);
  axis->SetAngle(200.0);
  axis->Update();
  EXPECT_EQ(log.errors.size(), 1u);
  EXPECT_EQ(axis->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(isEmpty(axis->GetDistanceField()));
}

TEST(MedialAxisOutputs, BothTellOfTheExecution)
{
  auto axis = boxAxis(13);
  axis->GenerateDistanceFieldOn();
  axis->Update();
  for (const int port : { 0, 1 })
  {
    vtkDataObject* output = axis->GetOutputDataObject(port);
    EXPECT_EQ(textFigure(output, "Engine"), "Processor");
    EXPECT_EQ(textFigure(output, "Side"), "Interior");
    EXPECT_EQ(figure(output, "Samples"), axis->GetDistanceField()->GetNumberOfPoints());
    ASSERT_EQ(figures(output, "Seconds").size(), 7u);
    EXPECT_GT(figures(output, "Seconds")[6], 0.0);
  }
  axis->GenerateDistanceFieldOff();
  axis->Update(1);
  EXPECT_TRUE(figures(axis->GetDistanceField(), "Seconds").empty());
}

TEST(MedialAxisPieces, PieceZeroIsAllOfIt)
{
  auto whole = boxAxis(17);
  whole->Update();
  for (int piece = 0; piece < 3; ++piece)
  {
    auto part = boxAxis(17);
    part->GenerateDistanceFieldOn();
    part->UpdatePiece(piece, 3, 0);
    EXPECT_EQ(part->GetOutput()->GetNumberOfPoints(),
      piece == 0 ? whole->GetOutput()->GetNumberOfPoints() : 0);
    EXPECT_EQ(isEmpty(part->GetDistanceField()), piece != 0);
    EXPECT_EQ(part->GetErrorCode(), 0u);
  }
}

} // namespace

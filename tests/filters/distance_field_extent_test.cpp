// vtkMeshDistanceField: information, extents and pieces.
#include "filter_support.h"

#include "medial/grid.h"

#include <gtest/gtest.h>

#include <vtkCompositeDataSet.h>
#include <vtkContourFilter.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMeshDistanceField.h>
#include <vtkMultiBlockDataGroupFilter.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using namespace medial::test;
using Extent = std::array<int, 6>;
using SDDP = vtkStreamingDemandDrivenPipeline;

/// A cubic grid of `points` points along each axis.
vtkSmartPointer<vtkMeshDistanceField> lumpField(int points)
{
  const double h = 2.7 / (points - 1);
  auto field = vtkSmartPointer<vtkMeshDistanceField>::New();
  field->SetInputData(lumpPolyData());
  field->SetGridModeToExplicit();
  field->SetOrigin(-1.37, -1.31, -1.33);
  field->SetSpacing(h, h, h);
  field->SetDimensions(points, points, points);
  return field;
}

Extent extentOf(vtkImageData* image)
{
  Extent extent;
  image->GetExtent(extent.data());
  return extent;
}

/// Every point of `part` has the values of the same point of `whole`, ties of ids aside.
void expectPartOf(vtkImageData* part, vtkImageData* whole)
{
  const Extent extent = extentOf(part);
  const double h = whole->GetSpacing()[0];
  int differentSites = 0;
  vtkIdType i = 0;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x, ++i)
      {
        int index[3] = { x, y, z };
        const vtkIdType j = whole->ComputePointId(index);
        ASSERT_NEAR(distanceBetween(pointOf(part, i), pointOf(whole, j)), 0.0, 1e-9 * h);
        ASSERT_NEAR(valueOf(part, "Distance", i), valueOf(whole, "Distance", j), 1e-3 * h);
        differentSites += valueOf(part, "ClosestSite", i) != valueOf(whole, "ClosestSite", j);
      }
    }
  }
  ASSERT_EQ(i, part->GetNumberOfPoints());
  EXPECT_LE(differentSites, part->GetNumberOfPoints() / 100);
}

TEST(DistanceFieldInformation, IsThereBeforeTheUpdate)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(20);
  EventLog log(field);
  field->UpdateInformation();

  vtkInformation* info = field->GetOutputInformation(0);
  sphere->Update();
  double bounds[6];
  sphere->GetOutput()->GetBounds(bounds);
  const medial::Grid grid = medial::makeGrid(
    { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } }, 20);
  Extent whole;
  info->Get(SDDP::WHOLE_EXTENT(), whole.data());
  EXPECT_EQ(whole,
    (Extent{ 0, grid.dimensions[0] - 1, 0, grid.dimensions[1] - 1, 0, grid.dimensions[2] - 1 }));
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_DOUBLE_EQ(info->Get(vtkDataObject::ORIGIN())[axis], grid.origin[axis]);
    EXPECT_DOUBLE_EQ(info->Get(vtkDataObject::SPACING())[axis], grid.spacing[axis]);
  }
  EXPECT_EQ(info->Get(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT()), 1);
  EXPECT_EQ(vtkImageData::GetScalarType(info), VTK_FLOAT);
  EXPECT_EQ(vtkImageData::GetNumberOfScalarComponents(info), 1);
  EXPECT_EQ(log.executions, 0);
  EXPECT_TRUE(isEmpty(field->GetOutput()));

  field->Update();
  EXPECT_EQ(extentOf(field->GetOutput()), whole);
  EXPECT_EQ(log.executions, 1);
}

TEST(DistanceFieldInformation, SpacingModeKeepsTheSpacing)
{
  auto field = lumpField(2);
  field->SetGridModeToSpacing();
  field->SetSpacing(0.2, 0.25, 0.4);
  field->SetPadding(0.0);
  field->Update();
  vtkImageData* image = field->GetOutput();
  EXPECT_DOUBLE_EQ(image->GetSpacing()[1], 0.25);
  double mesh[6];
  lumpPolyData()->GetBounds(mesh);
  double grid[6];
  image->GetBounds(grid);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LE(grid[2 * axis], mesh[2 * axis] + 1e-9);
    EXPECT_GE(grid[2 * axis + 1], mesh[2 * axis + 1] - 1e-9);
    EXPECT_LT(grid[2 * axis + 1] - grid[2 * axis],
      mesh[2 * axis + 1] - mesh[2 * axis] + image->GetSpacing()[axis]);
  }
}

TEST(DistanceFieldInformation, ExplicitGridDoesNotUpdateTheInput)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetGridModeToExplicit();
  field->SetOrigin(-0.7, -0.6, -0.5);
  field->SetSpacing(0.1, 0.2, 0.3);
  field->SetDimensions(14, 7, 4);
  EventLog source(sphere);
  field->UpdateInformation();
  EXPECT_EQ(source.executions, 0);
  field->Update();
  vtkImageData* image = field->GetOutput();
  EXPECT_EQ(extentOf(image), (Extent{ 0, 13, 0, 6, 0, 3 }));
  EXPECT_DOUBLE_EQ(image->GetOrigin()[2], -0.5);
  EXPECT_DOUBLE_EQ(image->GetSpacing()[2], 0.3);
  EXPECT_EQ(source.executions, 1);
}

TEST(DistanceFieldInformation, InputIsExecutedOnce)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(8);
  EventLog source(sphere);
  field->UpdateInformation();
  field->Update();
  EXPECT_EQ(source.executions, 1);
}

// The source still has the piece of an earlier request.
TEST(DistanceFieldInformation, GridIsThatOfTheWholeInput)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->UpdatePiece(1, 2, 0);
  const vtkIdType cells = sphere->GetOutput()->GetNumberOfCells();
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputConnection(sphere->GetOutputPort());
  field->SetResolution(20);
  field->UpdateInformation();
  const double* origin = field->GetOutputInformation(0)->Get(vtkDataObject::ORIGIN());
  EXPECT_LT(origin[0], -0.5);
  EXPECT_LT(origin[1], -0.5);
  EXPECT_GT(sphere->GetOutput()->GetNumberOfCells(), cells);
}

TEST(DistanceFieldInformation, UnusedPointsDoNotStretchTheGrid)
{
  auto box = boxPolyData({ 1.0, 1.0, 1.0 });
  box->GetPoints()->InsertNextPoint(100.0, 0.0, 0.0);
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputData(box);
  field->SetResolution(8);
  field->Update();
  EXPECT_LT(field->GetOutput()->GetBounds()[1], 2.0);
}

TEST(DistanceFieldExtent, SubExtentHasTheValuesOfTheWhole)
{
  auto whole = lumpField(30);
  whole->Update();
  const Extent extents[] = { { 3, 17, 5, 9, 11, 20 }, { 0, 29, 0, 29, 14, 14 },
    { 29, 29, 0, 0, 0, 0 }, { 7, 8, 0, 20, 3, 4 } };
  for (const Extent& extent : extents)
  {
    auto part = lumpField(30);
    part->UpdateExtent(extent.data());
    EXPECT_EQ(extentOf(part->GetOutput()), extent);
    EXPECT_DOUBLE_EQ(part->GetOutput()->GetOrigin()[0], whole->GetOutput()->GetOrigin()[0]);
    EXPECT_EQ(figure(part->GetOutput(), "Samples"), part->GetOutput()->GetNumberOfPoints());
    EXPECT_EQ(figures(part->GetOutput(), "GridDimensions")[0], 30.0) << "that of the whole";
    expectPartOf(part->GetOutput(), whole->GetOutput());
  }
}

TEST(DistanceFieldExtent, SubExtentOutsideTheWholeIsRefused)
{
  auto field = lumpField(10);
  EventLog log(field);
  const int outside[6] = { 0, 30, 0, 9, 0, 9 };
  EXPECT_EQ(field->UpdateExtent(outside), 0);
  EXPECT_EQ(log.executions, 0);
  EXPECT_EQ(log.pipelineErrors, 1);
}

TEST(DistanceFieldExtent, SubExtentAfterTheWholeNeedsNoExecution)
{
  auto field = lumpField(16);
  EventLog log(field);
  field->Update();
  const int part[6] = { 2, 5, 2, 5, 2, 5 };
  field->UpdateExtent(part);
  EXPECT_EQ(log.executions, 1);
  EXPECT_EQ(extentOf(field->GetOutput()), (Extent{ 0, 15, 0, 15, 0, 15 }));
}

TEST(DistanceFieldExtent, GrowingRequestsExecuteAgain)
{
  auto field = lumpField(16);
  EventLog log(field);
  const int part[6] = { 2, 5, 2, 5, 2, 5 };
  field->UpdateExtent(part);
  EXPECT_EQ(extentOf(field->GetOutput()), (Extent{ 2, 5, 2, 5, 2, 5 }));
  const int more[6] = { 2, 5, 2, 5, 4, 9 };
  field->UpdateExtent(more);
  EXPECT_EQ(extentOf(field->GetOutput()), (Extent{ 2, 5, 2, 5, 4, 9 }));
  field->UpdateWholeExtent();
  EXPECT_EQ(extentOf(field->GetOutput()), (Extent{ 0, 15, 0, 15, 0, 15 }));
  EXPECT_EQ(log.executions, 3);
}

// Each piece is a part of the whole field, though the source would split the mesh with the pieces.
TEST(DistanceFieldExtent, PiecesSplitTheGridButNotTheInput)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(12);
  vtkNew<vtkMeshDistanceField> whole;
  whole->SetInputConnection(sphere->GetOutputPort());
  whole->SetResolution(18);
  whole->Update();
  vtkIdType points = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    vtkNew<vtkSphereSource> again;
    again->SetThetaResolution(12);
    vtkNew<vtkMeshDistanceField> part;
    part->SetInputConnection(again->GetOutputPort());
    part->SetResolution(18);
    part->UpdatePiece(piece, 3, 0);
    EXPECT_EQ(textFigure(part->GetOutput(), "SignMethod"), "Winding");
    expectPartOf(part->GetOutput(), whole->GetOutput());
    points += part->GetOutput()->GetNumberOfPoints();
  }
  EXPECT_GE(points, whole->GetOutput()->GetNumberOfPoints());
  EXPECT_LE(points, 2 * whole->GetOutput()->GetNumberOfPoints());
}

TEST(DistanceFieldExtent, GhostLevelsGrowThePiece)
{
  auto whole = lumpField(16);
  whole->Update();
  auto part = lumpField(16);
  part->UpdatePiece(1, 2, 1);
  expectPartOf(part->GetOutput(), whole->GetOutput());
  EXPECT_NE(part->GetOutput()->GetPointData()->GetArray("vtkGhostType"), nullptr);
}

// A reader in streaming: one slab of slices after the other through one filter.
TEST(DistanceFieldExtent, SlabsStreamThroughOneFilter)
{
  auto whole = lumpField(20);
  whole->Update();
  auto field = lumpField(20);
  EventLog log(field);
  for (int first = 0; first < 20; first += 6)
  {
    const int slab[6] = { 0, 19, 0, 19, first, std::min(first + 5, 19) };
    field->UpdateExtent(slab);
    EXPECT_EQ(extentOf(field->GetOutput())[4], first);
    expectPartOf(field->GetOutput(), whole->GetOutput());
  }
  EXPECT_EQ(log.executions, 4);
}

TEST(DistanceFieldExtent, DownstreamFilterGetsWhatItAsksFor)
{
  auto field = lumpField(24);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(field->GetOutputPort());
  contour->SetValue(0, 0.0);
  contour->Update();
  EXPECT_GT(contour->GetOutput()->GetNumberOfCells(), 100);
}

// VTK asks only once for information, and its filters read the extent without a check.
TEST(DistanceFieldExtent, RefusalIsRepeatedToADownstreamFilter)
{
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputData(lumpPolyData());
  field->SetResolution(1);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(field->GetOutputPort());
  contour->SetValue(0, 0.0);
  for (int update = 0; update < 3; ++update)
  {
    EventLog log(field);
    contour->Update();
    ASSERT_FALSE(log.errors.empty()) << update;
    EXPECT_NE(log.errors[0].find("resolution 1 is outside"), std::string::npos) << log.errors[0];
    EXPECT_EQ(field->GetErrorCode(), vtkMeshFieldAlgorithm::InvalidInputError);
    EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 0);
  }
  field->SetResolution(24);
  contour->Update();
  EXPECT_GT(contour->GetOutput()->GetNumberOfCells(), 100);
}

TEST(DistanceFieldExtent, EmptyBlockIsRefused)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>());
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputDataObject(blocks);
  EventLog log(field);
  field->Update();
  ASSERT_FALSE(log.errors.empty());
  EXPECT_NE(log.errors[0].find("the mesh has no cells"), std::string::npos) << log.errors[0];
  EXPECT_EQ(field->GetErrorCode(), vtkMeshFieldAlgorithm::InvalidInputError);
}

TEST(DistanceFieldExtent, CompositeInputGivesOneGridABlock)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, boxPolyData({ 2.0, 2.0, 2.0 }));
  blocks->SetBlock(1, lumpPolyData());
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputDataObject(blocks);
  field->SetGridModeToSpacing();
  field->SetSpacing(0.2, 0.2, 0.2);
  field->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(field->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  auto* box = vtkImageData::SafeDownCast(output->GetBlock(0));
  auto* lump = vtkImageData::SafeDownCast(output->GetBlock(1));
  ASSERT_TRUE(box && lump);
  EXPECT_NEAR(valueOf(box, "Distance", 0), std::sqrt(3.0) * (-box->GetBounds()[0] - 2.0), 1e-5);
  EXPECT_NE(lump->GetDimensions()[0], box->GetDimensions()[0]);
  vtkNew<vtkMeshDistanceField> alone;
  alone->SetInputData(lumpPolyData());
  alone->SetGridModeToSpacing();
  alone->SetSpacing(0.2, 0.2, 0.2);
  alone->Update();
  ASSERT_EQ(lump->GetNumberOfPoints(), alone->GetOutput()->GetNumberOfPoints());
  expectPartOf(lump, alone->GetOutput());
}

// The producer of the blocks must not be updated while the pipeline goes through them.
TEST(DistanceFieldExtent, CompositeInputMayComeFromAFilter)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkMultiBlockDataGroupFilter> group;
  group->AddInputConnection(sphere->GetOutputPort());
  group->AddInputDataObject(boxPolyData({ 2.0, 2.0, 2.0 }));
  vtkNew<vtkMeshDistanceField> field;
  field->SetInputConnection(group->GetOutputPort());
  field->SetResolution(12);
  EventLog log(field);
  field->Update();
  EXPECT_TRUE(log.errors.empty()) << log.errors[0];
  auto* output = vtkMultiBlockDataSet::SafeDownCast(field->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto* image = vtkImageData::SafeDownCast(output->GetBlock(i));
    ASSERT_NE(image, nullptr);
    EXPECT_NE(image->GetPointData()->GetArray("Distance"), nullptr);
  }
  sphere->SetRadius(3.0);
  field->Update();
  output = vtkMultiBlockDataSet::SafeDownCast(field->GetOutputDataObject(0));
  EXPECT_GT(vtkImageData::SafeDownCast(output->GetBlock(0))->GetBounds()[1], 3.0);
}

} // namespace

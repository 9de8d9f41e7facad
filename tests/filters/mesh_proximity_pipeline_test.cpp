// Frames, errors and the pipeline.
#include "proximity_pairs.h"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>

namespace
{

using namespace medial::test;

void move(vtkPolyData* mesh, const std::function<medial::Point3(const medial::Point3&)>& to)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoints()->SetPoint(i, to(pointOf(mesh, i)).data());
  }
  mesh->GetPoints()->Modified();
}

void expectError(const std::function<void(vtkMeshProximity*)>& spoil,
  const std::function<void(vtkMeshProximity*)>& repair, const std::string& words)
{
  auto filter = makeCubes(3.0);
  expectErrorAndRecovery(
    filter, [&] { spoil(filter); }, [&] { repair(filter); }, words);
  EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), 1.0, 1e-12) << words;
}

} // namespace

TEST(MeshProximityPipeline, FramesOfOneMeshAreThoseOfANewFilter)
{
  auto deforming = lumpPolyData();
  auto filter = proximityOf(deforming, boxPolyData({ 1, 1, 1 }));
  for (int frame = 0; frame < 6; ++frame)
  {
    move(deforming,
      [&](const medial::Point3& x) {
        return medial::Point3{ x[0] + 0.5, x[1] * 1.02, x[2] };
      });
    filter->Update();
    vtkNew<vtkPolyData> frozen;
    frozen->DeepCopy(deforming);
    auto fresh = proximityOf(frozen, boxPolyData({ 1, 1, 1 }));
    fresh->Update();
    EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), figure(fresh->GetOutput(), "Separation"),
      1e-12);
    EXPECT_EQ(figure(filter->GetOutput(), "Collide"), figure(fresh->GetOutput(), "Collide"));
    const double depth = figure(fresh->GetOutput(), "PenetrationDepth");
    EXPECT_NEAR(figure(filter->GetOutput(), "PenetrationDepth"), depth, 2e-3 * depth);
  }
}

// Two sheets over points of their own are welded where they lie on each other.
TEST(MeshProximityPipeline, PointsThatComeApartAreNoLongerWelded)
{
  auto mesh = squarePolyData();
  for (const double x : { -1.0, 1.0 })
  {
    mesh->GetPoints()->InsertNextPoint(x, -1.0, 0.0);
  }
  mesh->GetPoints()->InsertNextPoint(0.0, -1.0, 1.0);
  mesh->GetPolys()->InsertNextCell({ 4, 5, 6 });
  auto filter = proximityOf(mesh, boxPolyData({ 0.5, 0.5, 0.5 }));
  filter->SetTransformB(translation(0.0, -6.0, 0.0));
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), 4.5, 1e-12);
  mesh->GetPoints()->SetPoint(4, -1.0, -3.0, 0.0);
  mesh->GetPoints()->SetPoint(5, 1.0, -3.0, 0.0);
  mesh->GetPoints()->Modified();
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), 2.5, 1e-12);
  EXPECT_EQ(valueOf(filter->GetOutput(), "CellA", 0), 1.0);
  filter->SetTransformB(translation(0.0, 0.0, 5.0));
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), std::hypot(3.5, 0.5), 1e-12);
}

TEST(MeshProximityPipeline, MeshesAreReplaced)
{
  auto filter = makeCubes(3.0);
  filter->Update();
  for (int i = 1; i < 6; ++i)
  {
    // The old mesh dies; the new one may well live at its address.
    filter->SetInputData(0, boxPolyData({ 1.0 + 0.1 * i, 0.8, 0.6 }));
    filter->Update();
    EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), 1.0 - 0.1 * i, 1e-12);
  }
  filter->SetInputData(1, lumpPolyData());
  filter->Update();
  EXPECT_EQ(filter->GetMovedB()->GetNumberOfPoints(), lumpPolyData()->GetNumberOfPoints());
  EXPECT_EQ(filter->GetErrorCode(), 0u);
}

TEST(MeshProximityPipeline, ExecutesWhenSomethingChangedAndDoesNotModifyItself)
{
  vtkNew<vtkSphereSource> sphere;
  auto box = boxPolyData({ 1, 1, 1 });
  vtkNew<vtkMeshProximity> filter;
  filter->SetInputConnection(0, sphere->GetOutputPort());
  filter->SetInputData(1, box);
  auto transform = translation(3.0, 0.0, 0.0);
  filter->SetTransformB(transform);
  EventLog log(filter);
  filter->Update();
  const vtkMTimeType time = filter->GetMTime();
  filter->Update();
  EXPECT_EQ(log.executions, 1);
  EXPECT_EQ(filter->GetMTime(), time);
  transform->Translate(1.0, 0.0, 0.0);
  filter->Update();
  EXPECT_EQ(log.executions, 2);
  EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), 2.5, 2e-2);
  sphere->SetRadius(1.0);
  filter->Update();
  EXPECT_EQ(log.executions, 3);
  EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), 2.0, 1e-1);
  filter->Update(1);
  filter->Update(2);
  EXPECT_EQ(log.executions, 3);
}

TEST(MeshProximityPipeline, RefusesParametersOutsideTheirRange)
{
  using F = vtkMeshProximity*;
  expectError([](F f) { f->SetMaximumNumberOfContacts(-1); },
    [](F f) { f->SetMaximumNumberOfContacts(0); }, "contacts -1 is outside [0, infinity)");
  const auto repair = [](F f) { f->SetDepthTolerance(0.5); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectError([](F f) { f->SetDepthTolerance(0.0); }, repair, "tolerance 0 is outside (0, 1)");
  expectError([](F f) { f->SetDepthTolerance(1.0); }, repair, "tolerance 1 is outside (0, 1)");
  expectError([=](F f) { f->SetDepthTolerance(nan); }, repair, "tolerance nan is outside (0, 1)");
  expectError([](F f) { f->SetMaximumSeparation(-1.0); }, [](F f) { f->SetMaximumSeparation(2.0); },
    "maximum separation -1 is outside [0, infinity]");
  expectError([](F f) { f->SetNumberOfThreads(-1); }, [](F f) { f->SetNumberOfThreads(1); },
    "NumberOfThreads -1");
}

TEST(MeshProximityPipeline, RefusesUnusableInput)
{
  for (const int port : { 0, 1 })
  {
    const std::string name = port == 0 ? "mesh A: " : "mesh B: ";
    const auto repair = [port](vtkMeshProximity* f) {
      f->SetInputData(port, boxPolyData({ 1.0, 1.0, 1.0 }));
    };
    const auto with = [port](const std::function<void(vtkPolyData*)>& spoil)
    { return [=](vtkMeshProximity* f) { f->SetInputData(port, spoiledBox(spoil)); }; };
    expectError(with([](vtkPolyData* box) { box->Initialize(); }), repair,
      name + "the mesh has no cells");
    expectError(with([](vtkPolyData* box) { box->GetPoints()->SetPoint(3, HUGE_VAL, 0.0, 0.0); }),
      repair, name + "point 3");
  }
}

TEST(MeshProximityPipeline, RefusesTransformsThatCannotBeUndone)
{
  using F = vtkMeshProximity*;
  vtkNew<vtkTransform> flat;
  flat->Scale(1.0, 0.0, 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkTransform> undefined;
  undefined->Scale(nan, 1.0, 1.0);
  const auto far = translation(HUGE_VAL, 0.0, 0.0);
  expectError([&](F f) { f->SetTransformA(flat); }, [](F f) { f->SetTransformA(nullptr); },
    "mesh A: the determinant 0 of the transform");
  const auto repair = [](F f) { f->SetTransformB(translation(3, 0, 0)); };
  expectError([&](F f) { f->SetTransformB(undefined); }, repair,
    "mesh B: the determinant nan of the transform");
  expectError([&](F f) { f->SetTransformB(far); }, repair, "mesh B: ");
}

TEST(MeshProximityPipeline, AMissingInputIsAnErrorOfThePipeline)
{
  vtkNew<vtkMeshProximity> filter;
  filter->SetInputData(0, boxPolyData());
  EventLog log(filter);
  EXPECT_FALSE(update(filter));
  EXPECT_EQ(log.executions, 0);
  EXPECT_GE(log.pipelineErrors, 1);
}

TEST(MeshProximityPipeline, AnErrorLeavesNoOutputAtAll)
{
  auto filter = makeCubes(1.5);
  filter->Update();
  filter->SetDepthTolerance(2.0);
  expectInvalidInput(filter, "tolerance 2 is");
  EXPECT_EQ(filter->GetMovedA()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetMovedB()->GetNumberOfPoints(), 0);
}

TEST(MeshProximityPipeline, ReportsProgress)
{
  auto filter = proximityOf(lumpPolyData(), boxPolyData());
  EventLog log(filter);
  filter->Update();
  expectProgressToTheEnd(log);
  EXPECT_EQ(std::set<double>(log.progress.begin(), log.progress.end()).size(), 3u);
}

TEST(MeshProximityPipeline, AbortLeavesNothingAndTheNextUpdateExecutesAgain)
{
  for (const std::size_t event : { 1, 2 })
  {
    expectAbortLeavesNothing(proximityOf(lumpPolyData(), boxPolyData()), event);
  }
}

TEST(MeshProximityPipeline, PieceZeroIsAllOfIt)
{
  auto filter = makeCubes(1.5);
  filter->UpdatePiece(1, 3, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->UpdatePiece(0, 3, 0);
  EXPECT_GE(filter->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_EQ(filter->GetMovedB()->GetNumberOfPoints(), 8);
}

TEST(MeshProximityPipeline, ThreadsDoNotChangeTheResult)
{
  auto filter = proximityOf(lumpPolyData(), boxPolyData());
  filter->Update();
  auto single = proximityOf(lumpPolyData(), boxPolyData());
  single->SetNumberOfThreads(1);
  single->Update();
  EXPECT_EQ(figure(single->GetOutput(), "PenetrationDepth"),
    figure(filter->GetOutput(), "PenetrationDepth"));
  EXPECT_EQ(pointOf(single->GetOutput(), 0), pointOf(filter->GetOutput(), 0));
}

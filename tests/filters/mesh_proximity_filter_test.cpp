#include "filter_support.h"

#include "medial/proximity.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkMeshProximity.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>

namespace
{

using namespace medial::test;

vtkSmartPointer<vtkMeshProximity> make(vtkPolyData* a, vtkPolyData* b)
{
  auto filter = vtkSmartPointer<vtkMeshProximity>::New();
  filter->SetInputData(0, a);
  filter->SetInputData(1, b);
  return filter;
}

vtkSmartPointer<vtkTransform> translation(double x, double y, double z)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  transform->Translate(x, y, z);
  return transform;
}

/// Two cubes of side 2 about the origin, the second moved by `shift` along x.
vtkSmartPointer<vtkMeshProximity> makeCubes(double shift)
{
  auto filter = make(boxPolyData({ 1, 1, 1 }), boxPolyData({ 1, 1, 1 }));
  filter->SetTransformB(translation(shift, 0, 0));
  return filter;
}

/// A box of side 1 sunk 0.1 into the middle of the upper face of a plate.
vtkSmartPointer<vtkMeshProximity> makeSunkenBox()
{
  auto filter = make(boxPolyData({ 2.0, 2.0, 0.5 }), boxPolyData({ 0.5, 0.5, 0.5 }));
  filter->SetTransformB(translation(0.0, 0.0, 0.9));
  return filter;
}

double largest(vtkDataSet* data, const char* array)
{
  return data->GetPointData()->GetArray(array)->GetRange()[1];
}

void expectPoint(const std::vector<double>& x, const medial::Point3& expected)
{
  ASSERT_EQ(x.size(), 3u);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(x[axis], expected[axis], 1e-9);
  }
}

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

/// The points of the output that are contacts.
std::vector<vtkIdType> contactsOf(vtkPolyData* output)
{
  std::vector<vtkIdType> contacts;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    if (valueOf(output, "Kind", i) == 1.0)
    {
      contacts.push_back(i);
    }
  }
  return contacts;
}

} // namespace

TEST(MeshProximityFilter, DefaultsAreThoseOfTheLibrary)
{
  vtkNew<vtkMeshProximity> filter;
  const medial::ProximityOptions options;
  EXPECT_EQ(filter->GetSeparation() != 0, options.separation);
  EXPECT_EQ(filter->GetMaximumSeparation(), VTK_DOUBLE_MAX); // ParaView knows no infinity
  EXPECT_EQ(filter->GetDepths() != 0, options.depths);
  EXPECT_EQ(filter->GetTranslationalDepth() != 0, options.translationalDepth);
  EXPECT_EQ(filter->GetMaximumNumberOfContacts(), options.maxContacts);
  EXPECT_EQ(filter->GetDepthTolerance(), options.depthTolerance);
  EXPECT_EQ(filter->GetNumberOfThreads(), options.execution.threads);
  EXPECT_EQ(filter->GetTransformA(), nullptr);
  EXPECT_EQ(filter->GetTransformB(), nullptr);
}

TEST(MeshProximityFilter, ALineJoinsTheClosestPointsOfMeshesApart)
{
  auto filter = makeCubes(3.5);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(figure(output, "Separation"), 1.5);
  EXPECT_EQ(figure(output, "Collide"), 0.0);
  EXPECT_EQ(figure(output, "Intersect"), 0.0);
  EXPECT_EQ(figure(output, "InsideUndefined"), 0.0);
  EXPECT_EQ(figure(output, "PenetrationDepth"), 0.0);
  EXPECT_TRUE(std::isnan(figures(output, "DeepestPoint").at(0)));
  EXPECT_EQ(figures(output, "TranslationalDepth"), std::vector<double>({ 0.0, 0.0 }));
  EXPECT_GE(figure(output, "Seconds"), 0.0);

  ASSERT_EQ(output->GetNumberOfPoints(), 2);
  ASSERT_EQ(output->GetNumberOfLines(), 1);
  ASSERT_EQ(output->GetNumberOfCells(), 1);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(pointOf(output, 0)[0], 1.0);
  EXPECT_EQ(pointOf(output, 1)[0], 2.5);
  EXPECT_NEAR(distanceBetween(pointOf(output, 0), pointOf(output, 1)), 1.5, 1e-12);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    EXPECT_EQ(valueOf(output, "Kind", i), 0.0);
    EXPECT_EQ(vectorOf(output, "Normal", i), medial::Point3({ 1.0, 0.0, 0.0 }));
    EXPECT_EQ(valueOf(output, "Depth", i), 0.0);
    EXPECT_EQ(valueOf(output, "Manifold", i), -1.0);
    EXPECT_EQ(valueOf(output, "BodyA", i), 0.0);
    EXPECT_EQ(valueOf(output, "BodyB", i), 1.0);
    EXPECT_EQ(valueOf(output, "CellA", i), 1.0); // of the face at x = 1
    EXPECT_EQ(valueOf(output, "CellB", i), 0.0); // of the face at x = -1
  }
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Kind");
}

TEST(MeshProximityFilter, AVertexIsACommonPointOfMeshesThatIntersect)
{
  auto filter = makeCubes(1.5);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(figure(output, "Separation"), 0.0);
  EXPECT_EQ(figure(output, "Collide"), 1.0);
  EXPECT_EQ(figure(output, "Intersect"), 1.0);
  EXPECT_NEAR(figure(output, "PenetrationDepth"), 0.5, 0.5e-3);
  EXPECT_EQ(output->GetNumberOfLines(), 0);
  ASSERT_GE(output->GetNumberOfVerts(), 1);
  EXPECT_EQ(valueOf(output, "Kind", 0), 0.0);
  EXPECT_EQ(vectorOf(output, "Normal", 0), medial::Point3({ 0.0, 0.0, 0.0 }));
  const double common = pointOf(output, 0)[0];
  EXPECT_TRUE(common >= 0.5 && common <= 1.0) << common;
}

TEST(MeshProximityFilter, AMeshInsideTheOtherCollidesAndIsApart)
{
  auto filter = make(boxPolyData({ 1, 1, 1 }), boxPolyData({ 0.1, 0.1, 0.1 }));
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_NEAR(figure(output, "Separation"), 0.9, 1e-12);
  EXPECT_EQ(figure(output, "Collide"), 1.0);
  EXPECT_EQ(figure(output, "Intersect"), 0.0);
  EXPECT_NEAR(figure(output, "PenetrationDepth"), 0.9, 1e-3);
  EXPECT_EQ(output->GetNumberOfLines(), 1);
  EXPECT_EQ(figures(output, "DeepestPoint").size(), 3u);
}

TEST(MeshProximityFilter, MovedMeshesHaveTheDepthsOfTheirPoints)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(boxPolyData({ 1, 1, 1 }));
  normals->SplittingOff();
  normals->Update();
  vtkPolyData* input = normals->GetOutput();
  vtkNew<vtkFloatArray> own;
  own->SetName("Own");
  own->SetNumberOfValues(8);
  own->Fill(3.0);
  input->GetPointData()->AddArray(own);
  auto filter = make(boxPolyData({ 2.0, 2.0, 0.5 }), input);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.0, 0.0, 0.9);
  transform->Scale(0.5, 0.5, 0.5);
  filter->SetTransformB(transform);
  filter->Update();
  vtkPolyData* a = filter->GetMovedA();
  vtkPolyData* b = filter->GetMovedB();
  ASSERT_EQ(a->GetNumberOfPoints(), 8);
  ASSERT_EQ(b->GetNumberOfPoints(), 8);
  EXPECT_EQ(b->GetNumberOfPolys(), 6);
  EXPECT_EQ(b->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NE(b->GetPointData()->GetArray("Own"), nullptr);
  EXPECT_NE(b->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(input->GetPointData()->GetArray("PenetrationDepth"), nullptr);
  EXPECT_STREQ(b->GetPointData()->GetScalars()->GetName(), "PenetrationDepth");
  EXPECT_EQ(largest(a, "PenetrationDepth"), 0.0);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const medial::Point3 x = pointOf(b, i);
    EXPECT_NEAR(std::abs(x[2] - 0.9), 0.5, 1e-12);
    EXPECT_NEAR(valueOf(b, "PenetrationDepth", i), x[2] < 0.5 ? 0.1 : 0.0, 1e-12);
  }
}

TEST(MeshProximityFilter, DepthsThatAreNotWantedAreNotThere)
{
  auto filter = makeCubes(1.5);
  filter->DepthsOff();
  filter->TranslationalDepthOff();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(figure(output, "Collide"), 1.0);
  EXPECT_TRUE(contactsOf(output).empty());
  for (const char* name : { "PenetrationDepth", "PenetrationDepthAtMost", "DeepestPoint",
         "TranslationalDepth", "SeparatingTranslation" })
  {
    EXPECT_FALSE(output->GetFieldData()->HasArray(name)) << name;
  }
  EXPECT_FALSE(filter->GetMovedA()->GetPointData()->HasArray("PenetrationDepth"));
}

TEST(MeshProximityFilter, WithoutSeparationThereAreNoWitnesses)
{
  auto filter = makeCubes(3.5);
  filter->SeparationOff();
  filter->Update();
  EXPECT_TRUE(std::isnan(figure(filter->GetOutput(), "Separation")));
  EXPECT_EQ(figure(filter->GetOutput(), "Collide"), 0.0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MeshProximityFilter, MeshesBeyondTheMaximumSeparationAreNotCompared)
{
  auto filter = makeCubes(3.5);
  filter->SetMaximumSeparation(1.4);
  filter->Update();
  EXPECT_TRUE(std::isinf(figure(filter->GetOutput(), "Separation")));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  filter->SetMaximumSeparation(1.5);
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "Separation"), 1.5);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 1);
}

TEST(MeshProximityFilter, TransformsMoveBothMeshes)
{
  auto filter = makeCubes(3.5);
  vtkNew<vtkTransform> turned;
  turned->RotateZ(45.0);
  filter->SetTransformA(turned);
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), 2.5 - std::sqrt(2.0), 1e-12);
  turned->Identity();            // changed in place
  turned->Scale(-1.0, 1.0, 1.0); // turns the surface inside out
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "Separation"), 1.5);
  filter->SetTransformB(translation(1.5, 0, 0));
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "PenetrationDepth"), 0.5, 0.5e-3);
  filter->SetTransformB(nullptr);
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "Intersect"), 1.0);
}

TEST(MeshProximityFilter, FarFromTheOriginItIsTheSame)
{
  auto filter = makeCubes(3.5);
  filter->SetTransformA(translation(1e6, -2e6, 3e6));
  filter->SetTransformB(translation(1e6 + 3.5, -2e6, 3e6));
  filter->Update();
  EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), 1.5, 1e-8);
}

TEST(MeshProximityFilter, OpenMeshesThatLeaveInsideOpenHaveNoDepth)
{
  auto filter = make(boxPolyData({ 0.5, 0.5, 0.5 }), squarePolyData());
  filter->SetTransformA(translation(0.0, 0.0, 0.1));
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "Intersect"), 1.0);
  if (figure(filter->GetOutput(), "InsideUndefined") != 0.0)
  {
    EXPECT_TRUE(std::isnan(figure(filter->GetOutput(), "PenetrationDepth")));
    EXPECT_TRUE(std::isnan(valueOf(filter->GetMovedA(), "PenetrationDepth", 0)));
  }
}

TEST(MeshProximityFilter, CellsOfAllKindsAreCompared)
{
  auto filter = make(mixedPolyData(), boxPolyData({ 0.5, 0.5, 0.5 }));
  const medial::Point3 places[] = { { 4, 2, 2 }, { -4, 1, 1 }, { 0.5, 0.5, -4 }, { 1, -4, 1 } };
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    const medial::Point3& x = places[cell];
    filter->SetTransformB(translation(x[0], x[1], x[2]));
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    EXPECT_EQ(valueOf(output, "CellA", 0), static_cast<double>(cell));
    EXPECT_NEAR(distanceToCell(mixedPolyData(), cell, pointOf(output, 0)), 0.0, 1e-12);
  }
}

TEST(MeshProximityFilter, PointsOfNoCellHaveNoDepth)
{
  auto box = boxPolyData({ 0.1, 0.1, 0.1 });
  box->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  auto filter = make(box, boxPolyData({ 1, 1, 1 }));
  filter->Update();
  EXPECT_NEAR(valueOf(filter->GetMovedA(), "PenetrationDepth", 0), 0.9, 1e-12);
  EXPECT_TRUE(std::isnan(valueOf(filter->GetMovedA(), "PenetrationDepth", 8)));
}

TEST(MeshProximityFilter, FramesOfOneMeshAreThoseOfANewFilter)
{
  auto deforming = lumpPolyData();
  auto filter = make(deforming, boxPolyData({ 1, 1, 1 }));
  for (int frame = 0; frame < 6; ++frame)
  {
    move(deforming,
      [&](const medial::Point3& x) {
        return medial::Point3{ x[0] + 0.5, x[1] * 1.02, x[2] };
      });
    filter->Update();
    vtkNew<vtkPolyData> frozen;
    frozen->DeepCopy(deforming);
    auto fresh = make(frozen, boxPolyData({ 1, 1, 1 }));
    fresh->Update();
    EXPECT_NEAR(figure(filter->GetOutput(), "Separation"), figure(fresh->GetOutput(), "Separation"),
      1e-12);
    EXPECT_EQ(figure(filter->GetOutput(), "Collide"), figure(fresh->GetOutput(), "Collide"));
    const double depth = figure(fresh->GetOutput(), "PenetrationDepth");
    EXPECT_NEAR(figure(filter->GetOutput(), "PenetrationDepth"), depth, 2e-3 * depth);
  }
}

// Two sheets over points of their own are welded where they lie on each other.
TEST(MeshProximityFilter, PointsThatComeApartAreNoLongerWelded)
{
  auto mesh = squarePolyData();
  for (const double x : { -1.0, 1.0 })
  {
    mesh->GetPoints()->InsertNextPoint(x, -1.0, 0.0);
  }
  mesh->GetPoints()->InsertNextPoint(0.0, -1.0, 1.0);
  mesh->GetPolys()->InsertNextCell({ 4, 5, 6 });
  auto filter = make(mesh, boxPolyData({ 0.5, 0.5, 0.5 }));
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

TEST(MeshProximityFilter, MeshesAreReplaced)
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

TEST(MeshProximityFilter, ExecutesWhenSomethingChangedAndDoesNotModifyItself)
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

TEST(MeshProximityFilter, RefusesParametersOutsideTheirRange)
{
  using F = vtkMeshProximity*;
  expectError([](F f) { f->SetMaximumNumberOfContacts(-1); },
    [](F f) { f->SetMaximumNumberOfContacts(0); }, "contacts -1 is negative");
  const auto repair = [](F f) { f->SetDepthTolerance(0.5); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectError([](F f) { f->SetDepthTolerance(0.0); }, repair, "0.000000 is not in (0, 1)");
  expectError([](F f) { f->SetDepthTolerance(1.0); }, repair, "1.000000 is not in (0, 1)");
  expectError([=](F f) { f->SetDepthTolerance(nan); }, repair, "nan is not in (0, 1)");
  expectError([](F f) { f->SetMaximumSeparation(-1.0); }, [](F f) { f->SetMaximumSeparation(0.0); },
    "maximum separation -1.000000 is not 0 or more");
  expectError([](F f) { f->SetNumberOfThreads(-1); }, [](F f) { f->SetNumberOfThreads(1); },
    "NumberOfThreads -1");
}

TEST(MeshProximityFilter, RefusesUnusableInput)
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

TEST(MeshProximityFilter, RefusesTransformsThatCannotBeUndone)
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

TEST(MeshProximityFilter, AMissingInputIsAnErrorOfThePipeline)
{
  vtkNew<vtkMeshProximity> filter;
  filter->SetInputData(0, boxPolyData());
  EventLog log(filter);
  EXPECT_FALSE(update(filter));
  EXPECT_EQ(log.executions, 0);
  EXPECT_GE(log.pipelineErrors, 1);
}

TEST(MeshProximityFilter, AnErrorLeavesNoOutputAtAll)
{
  auto filter = makeCubes(1.5);
  filter->Update();
  filter->SetDepthTolerance(2.0);
  expectInvalidInput(filter, "2.000000");
  EXPECT_EQ(filter->GetMovedA()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetMovedB()->GetNumberOfPoints(), 0);
}

TEST(MeshProximityFilter, ReportsProgress)
{
  auto filter = make(lumpPolyData(), boxPolyData());
  EventLog log(filter);
  filter->Update();
  expectProgressToTheEnd(log);
  EXPECT_EQ(std::set<double>(log.progress.begin(), log.progress.end()).size(), 3u);
}

TEST(MeshProximityFilter, AbortLeavesNothingAndTheNextUpdateExecutesAgain)
{
  for (const std::size_t event : { 1, 2 })
  {
    expectAbortLeavesNothing(make(lumpPolyData(), boxPolyData()), event);
  }
}

TEST(MeshProximityFilter, PieceZeroIsAllOfIt)
{
  auto filter = makeCubes(1.5);
  filter->UpdatePiece(1, 3, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->UpdatePiece(0, 3, 0);
  EXPECT_GE(filter->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_EQ(filter->GetMovedB()->GetNumberOfPoints(), 8);
}

TEST(MeshProximityFilter, ThreadsDoNotChangeTheResult)
{
  auto filter = make(lumpPolyData(), boxPolyData());
  filter->Update();
  auto single = make(lumpPolyData(), boxPolyData());
  single->SetNumberOfThreads(1);
  single->Update();
  EXPECT_EQ(figure(single->GetOutput(), "PenetrationDepth"),
    figure(filter->GetOutput(), "PenetrationDepth"));
  EXPECT_EQ(pointOf(single->GetOutput(), 0), pointOf(filter->GetOutput(), 0));
}

TEST(MeshProximityFilter, ABoxOnAPlateHasFourContacts)
{
  auto filter = makeSunkenBox();
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const std::vector<vtkIdType> contacts = contactsOf(output);
  ASSERT_EQ(contacts.size(), 4u);
  EXPECT_EQ(output->GetNumberOfVerts(), 5); // with the common point
  const double degree = std::acos(-1.0) / 180.0;
  for (const vtkIdType i : contacts)
  {
    EXPECT_GE(vectorOf(output, "Normal", i)[2], std::cos(degree)); // from A, the plate, to B
    EXPECT_NEAR(valueOf(output, "Depth", i), 0.1, 1e-6);
    EXPECT_EQ(valueOf(output, "Manifold", i), 0.0);
    EXPECT_EQ(valueOf(output, "BodyA", i), 0.0);
    EXPECT_EQ(valueOf(output, "BodyB", i), 1.0);
    for (const char* name : { "CellA", "CellB" })
    {
      EXPECT_GE(valueOf(output, name, i), 0.0) << name;
      EXPECT_LT(valueOf(output, name, i), 6.0) << name;
    }
    const medial::Point3 x = pointOf(output, i);
    EXPECT_LE(std::max(std::abs(x[0]), std::abs(x[1])), 0.5 + 1e-9);
  }
}

TEST(MeshProximityFilter, ContactsAreAsManyAsAskedFor)
{
  auto filter = makeSunkenBox();
  for (const int count : { 1, 0 })
  {
    filter->SetMaximumNumberOfContacts(count);
    filter->Update();
    EXPECT_EQ(static_cast<int>(contactsOf(filter->GetOutput()).size()), count);
  }
}

TEST(MeshProximityFilter, BoxesAreSeparatedByTheShortestTranslation)
{
  auto filter = makeSunkenBox();
  filter->Update();
  const std::vector<double> bounds = figures(filter->GetOutput(), "TranslationalDepth");
  ASSERT_EQ(bounds.size(), 2u);
  EXPECT_NEAR(bounds[0], 0.1, 1e-6);
  EXPECT_NEAR(bounds[1], 0.1, 1e-6);
  const std::vector<double> shift = figures(filter->GetOutput(), "SeparatingTranslation");
  expectPoint(shift, { 0.0, 0.0, -bounds[1] });
  filter->SetTransformA(translation(shift[0], shift[1], shift[2]));
  filter->Update();
  EXPECT_LE(figure(filter->GetOutput(), "PenetrationDepth"), 1e-9);
}

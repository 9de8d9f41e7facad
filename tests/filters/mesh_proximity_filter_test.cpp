#include "proximity_pairs.h"

#include "medial/proximity.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace medial::test;

/// A box of side 1 sunk 0.1 into the middle of the upper face of a plate.
vtkSmartPointer<vtkMeshProximity> makeSunkenBox()
{
  auto filter = proximityOf(boxPolyData({ 2.0, 2.0, 0.5 }), boxPolyData({ 0.5, 0.5, 0.5 }));
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
  auto filter = proximityOf(boxPolyData({ 1, 1, 1 }), boxPolyData({ 0.1, 0.1, 0.1 }));
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
  auto filter = proximityOf(boxPolyData({ 2.0, 2.0, 0.5 }), input);
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

/// Mirrored in place, a cube around another one is the same cube.
TEST(MeshProximityFilter, TransformsMayMirrorInAnyExecution)
{
  vtkNew<vtkMeshProximity> filter;
  filter->SetInputData(0, boxPolyData({ 1.0, 1.0, 1.0 }));
  filter->SetInputData(1, boxPolyData({ 0.25, 0.25, 0.25 }));
  vtkNew<vtkTransform> transform;
  filter->SetTransformA(transform);
  for (const double scale : { 1.0, -1.0, 1.0 })
  {
    transform->Identity();
    transform->Scale(scale, 1.0, 1.0);
    filter->Update();
    EXPECT_EQ(figure(filter->GetOutput(), "Collide"), 1.0) << scale;
    EXPECT_NEAR(figure(filter->GetOutput(), "PenetrationDepth"), 0.75, 1e-3) << scale;
  }
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
  auto filter = proximityOf(boxPolyData({ 0.5, 0.5, 0.5 }), squarePolyData());
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
  auto filter = proximityOf(mixedPolyData(), boxPolyData({ 0.5, 0.5, 0.5 }));
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
  auto filter = proximityOf(box, boxPolyData({ 1, 1, 1 }));
  filter->Update();
  EXPECT_NEAR(valueOf(filter->GetMovedA(), "PenetrationDepth", 0), 0.9, 1e-12);
  EXPECT_TRUE(std::isnan(valueOf(filter->GetMovedA(), "PenetrationDepth", 8)));
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

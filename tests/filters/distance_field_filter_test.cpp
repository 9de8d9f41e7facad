// vtkMeshDistanceField: are its values right, and does it deliver the arrays that it promises?
#include "filter_support.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkIntArray.h>
#include <vtkMeshDistanceField.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using namespace medial::test;
using medial::Point3;

/// Largest error that DESIGN allows, as a share of the spacing.
constexpr double kTolerance = 1e-2;

vtkSmartPointer<vtkMeshDistanceField> fieldOf(vtkPolyData* mesh, int resolution)
{
  auto field = vtkSmartPointer<vtkMeshDistanceField>::New();
  field->SetInputData(mesh);
  field->SetResolution(resolution);
  return field;
}

TEST(DistanceFieldFilter, BoxHasItsAnalyticDistance)
{
  const Point3 halfSides = { 1.0, 0.7, 0.4 };
  auto field = fieldOf(boxPolyData(halfSides), 29);
  field->Update();
  vtkImageData* image = field->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], 29);
  EXPECT_EQ(field->GetUsedSignMethod(), vtkMeshFieldAlgorithm::SIGN_PSEUDONORMAL);
  const double h = image->GetSpacing()[0];
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double expected = boxDistance(halfSides, pointOf(image, i));
    ASSERT_NEAR(valueOf(image, "Distance", i), expected, kTolerance * h) << "point " << i;
  }
}

TEST(DistanceFieldFilter, AgreesWithVtkImplicitPolyDataDistance)
{
  auto lump = lumpPolyData();
  auto field = fieldOf(lump, 25);
  field->Update();
  vtkNew<vtkImplicitPolyDataDistance> reference;
  reference->SetInput(lump);
  vtkImageData* image = field->GetOutput();
  const double h = image->GetSpacing()[0];
  int inside = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double expected = reference->EvaluateFunction(pointOf(image, i).data());
    ASSERT_NEAR(valueOf(image, "Distance", i), expected, kTolerance * h) << "point " << i;
    inside += expected < 0.0 ? 1 : 0;
  }
  EXPECT_GT(inside, 1000);
}

TEST(DistanceFieldFilter, ClosestPointIsAtTheDistanceAndOnTheClosestCell)
{
  auto lump = lumpPolyData();
  auto field = fieldOf(lump, 17);
  field->Update();
  vtkImageData* image = field->GetOutput();
  const double h = image->GetSpacing()[0];
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const Point3 closest = vectorOf(image, "ClosestPoint", i);
    const auto cell = static_cast<vtkIdType>(valueOf(image, "ClosestCell", i));
    ASSERT_NEAR(distanceBetween(closest, pointOf(image, i)),
      std::abs(valueOf(image, "Distance", i)), kTolerance * h);
    ASSERT_GE(cell, 0);
    ASSERT_LT(cell, lump->GetNumberOfCells());
    ASSERT_NEAR(distanceToCell(lump, cell, closest), 0.0, kTolerance * h) << "point " << i;
  }
}

// Ids count vertices, lines, polygons and strips, whatever order the arrays were set in.
TEST(DistanceFieldFilter, CellIdsOfMixedInputAreThoseOfVtk)
{
  auto mixed = mixedPolyData();
  auto field = fieldOf(mixed, 33);
  field->Update();
  vtkImageData* image = field->GetOutput();
  EXPECT_EQ(field->GetUsedSignMethod(), vtkMeshFieldAlgorithm::SIGN_NONE);
  const double h = image->GetSpacing()[0];
  int samples[4] = {};
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const Point3 x = pointOf(image, i);
    double nearest = HUGE_VAL;
    for (vtkIdType cell = 0; cell < mixed->GetNumberOfCells(); ++cell)
    {
      nearest = std::min(nearest, distanceToCell(mixed, cell, x));
    }
    const auto cell = static_cast<vtkIdType>(valueOf(image, "ClosestCell", i));
    ASSERT_TRUE(cell >= 0 && cell < 4) << cell;
    ++samples[cell];
    ASSERT_NEAR(valueOf(image, "Distance", i), nearest, kTolerance * h);
    ASSERT_NEAR(distanceToCell(mixed, cell, x), nearest, kTolerance * h) << "point " << i;
  }
  for (int cell = 0; cell < 4; ++cell)
  {
    EXPECT_GT(samples[cell], 100) << "no region for cell " << cell;
  }
}

TEST(DistanceFieldFilter, StripsAreTheTrianglesThatVtkMakesOfThem)
{
  auto mixed = mixedPolyData();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mixed);
  triangles->Update();
  auto strips = fieldOf(mixed, 21);
  auto flat = fieldOf(triangles->GetOutput(), 21);
  strips->Update();
  flat->Update();
  const double h = flat->GetOutput()->GetSpacing()[0];
  ASSERT_EQ(strips->GetOutput()->GetNumberOfPoints(), flat->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(strips->GetNumberOfTriangles(), flat->GetNumberOfTriangles());
  for (vtkIdType i = 0; i < flat->GetOutput()->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(valueOf(strips->GetOutput(), "Distance", i),
      valueOf(flat->GetOutput(), "Distance", i), kTolerance * h);
  }
}

// A closed strip keeps the orientation of its triangles: inside stays negative.
TEST(DistanceFieldFilter, ClosedSurfaceOfStripsIsSigned)
{
  auto box = boxPolyData({ 1.0, 1.0, 1.0 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 4, 0, 5, 1, 7, 3, 6, 2, 4, 0 });
  strips->InsertNextCell({ 0, 2, 1, 3 });
  strips->InsertNextCell({ 4, 5, 6, 7 });
  box->SetPolys(nullptr);
  box->SetStrips(strips);
  auto field = fieldOf(box, 15);
  field->Update();
  ASSERT_EQ(field->GetErrorCode(), 0u);
  EXPECT_TRUE(field->GetClosed());
  EXPECT_TRUE(field->GetOriented());
  EXPECT_EQ(field->GetUsedSignMethod(), vtkMeshFieldAlgorithm::SIGN_PSEUDONORMAL);
  vtkImageData* image = field->GetOutput();
  const double h = image->GetSpacing()[0];
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(valueOf(image, "Distance", i), boxDistance({ 1.0, 1.0, 1.0 }, pointOf(image, i)),
      kTolerance * h);
  }
}

TEST(DistanceFieldFilter, ArraysHaveTheirNamesAndTypes)
{
  auto field = fieldOf(boxPolyData({ 1.0, 1.0, 1.0 }), 9);
  field->Update();
  vtkPointData* data = field->GetOutput()->GetPointData();
  const struct
  {
    const char* name;
    int type;
    int components;
  } expected[] = { { "Distance", VTK_FLOAT, 1 }, { "ClosestPoint", VTK_FLOAT, 3 },
    { "ClosestCell", VTK_ID_TYPE, 1 }, { "ClosestFeature", VTK_UNSIGNED_CHAR, 1 },
    { "ClosestSite", VTK_INT, 1 } };
  EXPECT_EQ(data->GetNumberOfArrays(), 5);
  for (const auto& array : expected)
  {
    ASSERT_NE(data->GetArray(array.name), nullptr) << array.name;
    EXPECT_EQ(data->GetArray(array.name)->GetDataType(), array.type) << array.name;
    EXPECT_EQ(data->GetArray(array.name)->GetNumberOfComponents(), array.components);
    EXPECT_EQ(data->GetArray(array.name)->GetNumberOfTuples(),
      field->GetOutput()->GetNumberOfPoints());
  }
  EXPECT_EQ(data->GetScalars(), data->GetArray("Distance"));
}

TEST(DistanceFieldFilter, ArraysCanBeSwitchedOff)
{
  auto field = fieldOf(boxPolyData({ 1.0, 1.0, 1.0 }), 9);
  field->GenerateClosestPointOff();
  field->GenerateClosestSiteOff();
  field->Update();
  vtkPointData* data = field->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 3);
  EXPECT_EQ(data->GetArray("ClosestPoint"), nullptr);
  EXPECT_EQ(data->GetArray("ClosestSite"), nullptr);
  field->GenerateClosestCellOff();
  field->GenerateClosestFeatureOff();
  field->Update();
  EXPECT_EQ(field->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_NEAR(valueOf(field->GetOutput(), "Distance", 9 * 9 * 9 / 2), -1.0, 1e-5);
}

TEST(DistanceFieldFilter, FeaturesAndSitesOfABox)
{
  auto field = fieldOf(boxPolyData({ 1.0, 1.0, 1.0 }), 9);
  field->Update();
  vtkImageData* image = field->GetOutput();
  const vtkIdType corner = 0;
  const vtkIdType besideFace = image->ComputePointId(std::array<int, 3>{ 4, 4, 0 }.data());
  const vtkIdType besideEdge = image->ComputePointId(std::array<int, 3>{ 4, 0, 0 }.data());
  EXPECT_EQ(valueOf(image, "ClosestFeature", corner), 0.0);
  EXPECT_EQ(valueOf(image, "ClosestFeature", besideEdge), 1.0);
  EXPECT_NE(valueOf(image, "ClosestFeature", besideFace), 0.0); // a face, or the quad's diagonal
  // 12 faces come first, then 18 edges, then 8 vertices.
  EXPECT_EQ(field->GetNumberOfSites(), 12 + 18 + 8);
  EXPECT_GE(valueOf(image, "ClosestSite", corner), 30.0);
  EXPECT_LT(valueOf(image, "ClosestSite", corner), 38.0);
  EXPECT_GE(valueOf(image, "ClosestSite", besideEdge), 12.0);
  EXPECT_LT(valueOf(image, "ClosestSite", besideEdge), 30.0);
}

TEST(DistanceFieldFilter, SignMethodNoneKeepsTheMagnitude)
{
  const Point3 halfSides = { 1.0, 0.8, 0.6 };
  auto field = fieldOf(boxPolyData(halfSides), 15);
  field->SetSignMethodToNone();
  field->Update();
  EXPECT_EQ(field->GetUsedSignMethod(), vtkMeshFieldAlgorithm::SIGN_NONE);
  vtkImageData* image = field->GetOutput();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(valueOf(image, "Distance", i), std::abs(boxDistance(halfSides, pointOf(image, i))),
      kTolerance * image->GetSpacing()[0]);
  }
}

TEST(DistanceFieldFilter, OpenMeshIsUnsigned)
{
  auto field = fieldOf(squarePolyData(), 11);
  field->SetPadding(0.5);
  field->Update();
  EXPECT_EQ(field->GetUsedSignMethod(), vtkMeshFieldAlgorithm::SIGN_NONE);
  EXPECT_STREQ(field->GetUsedSignMethodAsString(), "None");
  EXPECT_FALSE(field->GetClosed());
  EXPECT_GE(field->GetOutput()->GetScalarRange()[0], 0.0);
}

TEST(DistanceFieldFilter, TellsWhatItDid)
{
  auto field = fieldOf(boxPolyData({ 1.0, 1.0, 1.0 }), 12);
  EXPECT_STREQ(field->GetRenderer(), "");
  EXPECT_EQ(field->GetUsedSignMethod(), vtkMeshFieldAlgorithm::SIGN_AUTO);
  field->Update();
  EXPECT_STRNE(field->GetRenderer(), "");
  EXPECT_STRNE(field->GetRendererVersion(), "");
  EXPECT_EQ(field->GetNumberOfTriangles(), 12);
  EXPECT_EQ(field->GetNumberOfVertices(), 8);
  EXPECT_EQ(field->GetNumberOfComponents(), 1);
  EXPECT_EQ(field->GetNumberOfDegenerateTriangles(), 0);
  EXPECT_TRUE(field->GetClosed());
  EXPECT_TRUE(field->GetManifold());
  EXPECT_EQ(field->GetNumberOfSamples(), 12 * 12 * 12);
  EXPECT_GT(field->GetNumberOfCandidatePairs(), 0);
  EXPECT_EQ(field->GetNumberOfPolygons() > 0,
    field->GetUsedEngine() == vtkMeshFieldAlgorithm::ENGINE_RASTERISER);
  EXPECT_GE(field->GetNumberOfFragments(), field->GetNumberOfSamples());
  EXPECT_GT(field->GetSitesSeconds() + field->GetCullSeconds() + field->GetPolygonsSeconds() +
      field->GetDrawSeconds() + field->GetResolveSeconds(),
    0.0);
  EXPECT_EQ(field->GetMedialSeconds(), 0.0);
  int dimensions[3];
  field->GetUsedDimensions(dimensions);
  EXPECT_EQ(dimensions[2], 12);
}

// VTK's arrays would end the process.
TEST(DistanceFieldFilter, RefusesAGridLargerThanMemory)
{
  auto field = fieldOf(boxPolyData({ 1.0, 1.0, 1.0 }), 8192);
  EventLog log(field);
  field->Update();
  ASSERT_EQ(log.errors.size(), 1u);
  EXPECT_NE(log.errors[0].find("a grid of 549755813888 points needs"), std::string::npos)
    << log.errors[0];
  EXPECT_EQ(field->GetErrorCode(),
    static_cast<unsigned long>(vtkMeshFieldAlgorithm::OutOfMemoryError));
  EXPECT_TRUE(isEmpty(field->GetOutput()));
  field->SetResolution(8);
  field->Update();
  EXPECT_EQ(field->GetErrorCode(), 0u);
  EXPECT_EQ(field->GetOutput()->GetNumberOfPoints(), 512);
}

TEST(DistanceFieldFilter, PassesFieldData)
{
  auto box = boxPolyData({ 1.0, 1.0, 1.0 });
  vtkNew<vtkIntArray> note;
  note->SetName("Note");
  note->InsertNextValue(7);
  box->GetFieldData()->AddArray(note);
  auto field = fieldOf(box, 8);
  field->Update();
  EXPECT_NE(field->GetOutput()->GetFieldData()->GetArray("Note"), nullptr);
}

} // namespace

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
#include <utility>
#include <vector>

namespace
{

using namespace medial::test;
using medial::Point3;

/// Maximum error allowed, as a share of the spacing.
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
  EXPECT_EQ(textFigure(field->GetOutput(), "SignMethod"), "Winding");
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
  EXPECT_EQ(textFigure(field->GetOutput(), "SignMethod"), "None");
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
  EXPECT_EQ(figure(strips->GetOutput(), "Triangles"), figure(flat->GetOutput(), "Triangles"));
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
  EXPECT_EQ(figure(field->GetOutput(), "Closed"), 1.0);
  EXPECT_EQ(figure(field->GetOutput(), "Oriented"), 1.0);
  EXPECT_EQ(textFigure(field->GetOutput(), "SignMethod"), "Winding");
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
  EXPECT_EQ(figure(image, "Sites"), 12 + 18 + 8);
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
  EXPECT_EQ(textFigure(field->GetOutput(), "SignMethod"), "None");
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
  EXPECT_EQ(textFigure(field->GetOutput(), "SignMethod"), "None");
  EXPECT_EQ(figure(field->GetOutput(), "Closed"), 0.0);
  EXPECT_GE(field->GetOutput()->GetScalarRange()[0], 0.0);
}

TEST(DistanceFieldFilter, FieldDataTellsWhatItDid)
{
  auto field = fieldOf(boxPolyData({ 1.0, 1.0, 1.0 }), 12);
  field->Update();
  vtkDataObject* output = field->GetOutput();
  const std::pair<const char*, double> expected[] = { { "Triangles", 12 }, { "Vertices", 8 },
    { "Components", 1 }, { "DegenerateTriangles", 0 }, { "Closed", 1 }, { "Manifold", 1 },
    { "Oriented", 1 }, { "Sites", 12 + 18 + 8 }, { "Samples", 12 * 12 * 12 }, { "Polygons", 0 } };
  for (const auto& [name, value] : expected)
  {
    EXPECT_EQ(figure(output, name), value) << name;
  }
  EXPECT_GT(figure(output, "CandidatePairs"), 0);
  EXPECT_GE(figure(output, "Fragments"), figure(output, "Samples"));
  EXPECT_EQ(textFigure(output, "SignMethod"), "Winding");
  EXPECT_EQ(textFigure(output, "Engine"), "Processor");
  EXPECT_EQ(figures(output, "GridDimensions"), std::vector<double>(3, 12.0));
  EXPECT_EQ(figures(output, "GridSpacing")[1], field->GetOutput()->GetSpacing()[1]);
  EXPECT_EQ(figures(output, "GridOrigin")[2], field->GetOutput()->GetOrigin()[2]);
}

TEST(DistanceFieldFilter, SecondsOfThePhasesHaveNames)
{
  auto field = fieldOf(boxPolyData({ 1.0, 1.0, 1.0 }), 12);
  field->Update();
  vtkDataArray* seconds = field->GetOutput()->GetFieldData()->GetArray("Seconds");
  ASSERT_NE(seconds, nullptr);
  const char* const names[] = { "Sites", "Sign", "Cull", "Polygons", "Draw", "Resolve", "Medial" };
  ASSERT_EQ(seconds->GetNumberOfComponents(), 7);
  double sum = 0.0;
  for (int i = 0; i < 7; ++i)
  {
    EXPECT_STREQ(seconds->GetComponentName(i), names[i]);
    sum += seconds->GetComponent(0, i);
  }
  EXPECT_GT(sum, 0.0);
  EXPECT_EQ(seconds->GetComponent(0, 6), 0.0);
}

TEST(DistanceFieldFilter, OnlyEnginesOnADeviceTellOfOpenGL)
{
  auto field = fieldOf(boxPolyData({ 1.0, 1.0, 1.0 }), 12);
  field->SetEngineToRasteriser();
  field->Update();
  vtkDataObject* output = field->GetOutput();
  EXPECT_EQ(textFigure(output, "Engine"), "Rasteriser");
  EXPECT_GT(figure(output, "Polygons"), 0);
  EXPECT_NE(textFigure(output, "Renderer"), "");
  EXPECT_NE(textFigure(output, "RendererVersion"), "");
  EXPECT_NE(output->GetFieldData()->GetArray("SoftwareRenderer"), nullptr);
  field->SetEngineToDevice();
  field->Update();
  EXPECT_EQ(textFigure(output, "Engine"), "Device");
  EXPECT_NE(textFigure(output, "Renderer"), "");
  field->SetEngineToProcessor();
  field->Update();
  for (const char* name : { "Renderer", "RendererVersion", "SoftwareRenderer" })
  {
    EXPECT_EQ(output->GetFieldData()->GetAbstractArray(name), nullptr) << name;
  }
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

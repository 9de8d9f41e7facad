// The surfaces of solids in images.
#include "labelled_ball.h"

#include "support/errors.h"
#include "support/files.h"

#include "medial/error.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include "vtkMeshConversion.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace medial::test
{
namespace
{

using files::Scan;
using files::ScanSurface;

void expectNoLabel(const Scan& scan, long long label, const std::string& words)
{
  try
  {
    extractSurface(scan, ofLabel(label), "a.nrrd");
    ADD_FAILURE() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.what(),
      "a.nrrd: has no voxel with the label " + std::to_string(label) + "; " + words);
  }
}

TEST(ScanSurface, LabelsThatDoNotOccurAreToldThoseThatDo)
{
  const Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  expectNoLabel(scan, 4, "those that occur: 0, 3, 7");
}

// A voxel cannot have them; the nearest value that it can have is not meant.
TEST(ScanSurface, LabelsBeyondTheTypeOfTheImageDoNotOccur)
{
  const LabelImage image([](double r) { return r < kRadius ? 32767 : r < 5.0 ? -32768 : 0; });
  const Scan scan = readText("a.nrrd", nrrdFile(image, "raw"));
  expectNoLabel(scan, 32768, "those that occur: -32768, 0, 32767");
  expectNoLabel(scan, -32769, "those that occur: -32768, 0, 32767");
}

// Doubles have whole numbers exactly up to 2^53.
TEST(ScanSurface, LargeLabelsAreComparedAsIntegers)
{
  Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  scan.image->AllocateScalars(VTK_TYPE_INT64, 1);
  auto* const values = static_cast<std::int64_t*>(scan.image->GetScalarPointer());
  std::fill_n(values, scan.image->GetNumberOfPoints(), std::int64_t{ 9007199254740992 });
  values[30 * 25 * 6 + 30 * 12 + 15] = 9007199254740993;
  EXPECT_EQ(extractSurface(scan, ofLabel(9007199254740993), "a.nrrd")->GetNumberOfPolys(), 8);
  expectNoLabel(scan, 9007199254740994, "those that occur: 9007199254740992, 9007199254740993");
  scan.image->AllocateScalars(VTK_TYPE_UINT64, 1);
  std::fill_n(static_cast<std::uint64_t*>(scan.image->GetScalarPointer()),
    scan.image->GetNumberOfPoints(), std::numeric_limits<std::uint64_t>::max());
  expectNoLabel(scan, -1, "those that occur: 18446744073709551615");
}

// As of a NIfTI file with a slope of 0.1 in single precision.
TEST(ScanSurface, ScaledLabelsMayBeRounded)
{
  Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  vtkDataArray* stored = scan.image->GetPointData()->GetScalars();
  vtkNew<vtkDoubleArray> scaled;
  for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
  {
    scaled->InsertNextValue(static_cast<double>(0.1F) * 10.0 * stored->GetComponent(i, 0));
  }
  scan.image->GetPointData()->SetScalars(scaled);
  EXPECT_GT(extractSurface(scan, ofLabel(kLabel), "a.nrrd")->GetNumberOfPolys(), 100);
  expectNoLabel(scan, 4, "those that occur: 0, 3, 7");
  scaled->SetValue(0, 4.00001);
  expectNoLabel(scan, 4, "those that occur: 0, 3, 4.00001, 7");
  scaled->SetValue(0, 4.0000045);
  expectNoLabel(scan, 4, "those that occur: 0, 3, 4.0000045, 7");
}

TEST(ScanSurface, LabelsThatOccurAreNumbers)
{
  Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  const vtkIdType voxels = scan.image->GetNumberOfPoints();
  scan.image->AllocateScalars(VTK_FLOAT, 1);
  vtkDataArray* values = scan.image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < voxels; ++i)
  {
    values->SetComponent(i, 0, i % 2 == 0 ? std::nan("") : 1.5 * (i % 3));
  }
  expectNoLabel(scan, 1, "those that occur: 0, 1.5, 3");
  values->Fill(std::nan(""));
  expectNoLabel(scan, 1, "those that occur: none");
}

// Doubles have them exactly up to 2^53, and six digits do not.
TEST(ScanSurface, LargeLabelsAreToldExactly)
{
  Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  scan.image->AllocateScalars(VTK_DOUBLE, 1);
  vtkDataArray* values = scan.image->GetPointData()->GetScalars();
  values->Fill(614454277.0);
  values->SetComponent(5, 0, 614454278.0);
  values->SetComponent(6, 0, -9007199254740991.0);
  values->SetComponent(7, 0, 1e30);
  expectNoLabel(scan, 5, "those that occur: -9007199254740991, 614454277, 614454278, 1e+30");
}

// The surface would be points. A solid of the greatest value has one with area.
TEST(ScanSurface, AnIsovalueOfSingleVoxelsIsRefused)
{
  Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  vtkDataArray* values = scan.image->GetPointData()->GetScalars();
  EXPECT_GT(extractSurface(scan, ofValue(7.0), "a.nrrd")->GetNumberOfPolys(), 0);
  values->SetComponent(30 * 25 * 6 + 30 * 12 + 15, 0, 9.0);
  values->Modified(); // their range is kept
  expectError([&] { extractSurface(scan, ofValue(9.0), "a.nrrd"); }, ErrorCode::InvalidInput,
    "a.nrrd: has no surface at the isovalue 9: its values are in [0, 9]");
  EXPECT_GT(extractSurface(scan, ofValue(8.5), "a.nrrd")->GetNumberOfPolys(), 0);
}

TEST(ScanSurface, AnImageWithoutNumbersHasNoRange)
{
  Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  scan.image->AllocateScalars(VTK_FLOAT, 1);
  scan.image->GetPointData()->GetScalars()->Fill(std::nan(""));
  expectError([&] { extractSurface(scan, ofValue(0.5), "a.nrrd"); }, ErrorCode::InvalidInput,
    "a.nrrd: has no surface at the isovalue 0.5: none of its values is a finite number");
}

// Grey values that fall from the centre, 100 a unit: the interpolated surface is nearly exact.
LabelImage greyBall(double sign)
{
  return LabelImage(
    [sign](double r) { return static_cast<int>(std::lround(sign * (500 - 100 * r))); });
}

// All edges of the grid at a voxel with the isovalue end in the same point.
TEST(ScanSurface, IsClosedWhereVoxelsHaveTheIsovalue)
{
  const std::vector<int> few{ -2, -1, 0, 1, 2 };
  const std::vector<int> far{ -2000000000, -1, 0, 1, 2000000000 };
  std::mt19937 random(1);
  for (const int type : { VTK_SHORT, VTK_INT, VTK_FLOAT, VTK_DOUBLE })
  {
    for (int image = 0; image < 10; ++image)
    {
      Scan scan;
      scan.frame = files::makeFrame({}, { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } });
      scan.image = vtkSmartPointer<vtkImageData>::New();
      scan.image->SetDimensions(6, 6, 6);
      scan.image->AllocateScalars(type, 1);
      const std::vector<int>& values = type == VTK_SHORT || image % 2 == 0 ? few : far;
      for (vtkIdType i = 0; i < scan.image->GetNumberOfPoints(); ++i)
      {
        scan.image->GetPointData()->GetScalars()->SetComponent(i, 0, values[random() % 5]);
      }
      const auto surface = extractSurface(scan, ofValue(0.0), "a.nrrd");
      const TriangleMesh mesh = buildTriangleMesh(vtkMeshConversion::ToMeshInput(surface));
      EXPECT_EQ(mesh.degenerateTriangles, 0) << type;
      EXPECT_EQ(mesh.points.size(), surface->GetNumberOfPoints()) << type;
      const MeshConnectivity connectivity = analyseConnectivity(mesh);
      EXPECT_TRUE(connectivity.closed()) << type;
      EXPECT_TRUE(connectivity.manifold()) << type;
    }
  }
}

// By at most a hundredth of a voxel, here of 0.4, 0.5 and 1.
TEST(ScanSurface, HardlyMovesWhereVoxelsHaveTheIsovalue)
{
  const Scan scan = readText("a.nrrd", nrrdFile(greyBall(1.0), "raw"));
  const auto through = extractSurface(scan, ofValue(100.0), "a.nrrd");
  const auto beside = extractSurface(scan, ofValue(100.0 - 1e-5), "a.nrrd");
  ASSERT_EQ(through->GetNumberOfPoints(), beside->GetNumberOfPoints());
  double farthest = 0.0;
  for (vtkIdType i = 0; i < through->GetNumberOfPoints(); ++i)
  {
    double point[3];
    through->GetPoint(i, point);
    farthest =
      std::max(farthest, std::sqrt(vtkMath::Distance2BetweenPoints(point, beside->GetPoint(i))));
  }
  EXPECT_LT(farthest, 0.0101);
  EXPECT_GT(farthest, 0.001);
}

// Differences of unsigned integers, and those of large ones, do not fit into their type.
TEST(ScanSurface, IsTheSameForEveryTypeOfInteger)
{
  const Scan expected = readText("a.nrrd", nrrdFile(greyBall(1.0), "raw"));
  const double volume = volumeOf(extractSurface(expected, ofValue(100.5), "a.nrrd"));
  vtkDataArray* values = expected.image->GetPointData()->GetScalars();
  for (const int type : { VTK_INT, VTK_UNSIGNED_INT, VTK_TYPE_INT64, VTK_TYPE_UINT64 })
  {
    Scan scan = readText("a.nrrd", nrrdFile(greyBall(1.0), "raw"));
    scan.image->AllocateScalars(type, 1);
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      scan.image->GetPointData()->GetScalars()->SetComponent(i, 0,
        values->GetComponent(i, 0) + 1000.0);
    }
    EXPECT_NEAR(volumeOf(extractSurface(scan, ofValue(1100.5), "a.nrrd")), volume, 1e-3) << type;
  }
}

TEST(ScanSurface, IsovaluesOutsideTheRangeAreToldIt)
{
  const Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  for (const double value : { 0.0, 7.5, -1.0 })
  {
    try
    {
      extractSurface(scan, ofValue(value), "a.nrrd");
      ADD_FAILURE() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_TRUE(contains(error.what(), "its values are in [0, 7]")) << error.what();
    }
  }
}

TEST(ScanSurface, OfGreyValuesIsInterpolated)
{
  for (const double sign : { 1.0, -1.0 }) // bright or dark inside
  {
    const Scan scan = readText("a.nrrd", nrrdFile(greyBall(sign), "gzip"));
    const auto surface = extractSurface(scan, ofValue(sign * 100.0), "a.nrrd");
    ASSERT_GT(surface->GetNumberOfPoints(), 500);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      ASSERT_NEAR(distanceToCentre(surface->GetPoint(i)), 4.0, 0.08);
    }
    EXPECT_TRUE(isClosed(surface));
    EXPECT_NEAR(volumeOf(surface), 268.0, 8.0); // positive: it is not inside out
  }
}

TEST(ScanSurface, SmoothingMovesPointsByLessThanAVoxel)
{
  const Scan scan = readText("a.nrrd", nrrdFile(ball(), "raw"));
  ScanSurface rough = ofLabel(kLabel);
  rough.smoothing = 0;
  const auto steps = extractSurface(scan, rough, "a.nrrd");
  const auto smooth = extractSurface(scan, ofLabel(kLabel), "a.nrrd");
  ASSERT_EQ(steps->GetNumberOfPoints(), smooth->GetNumberOfPoints());
  double sumOfSteps = 0.0;
  double sumOfSmooth = 0.0;
  for (vtkIdType i = 0; i < steps->GetNumberOfPoints(); ++i)
  {
    sumOfSteps += std::abs(distanceToCentre(steps->GetPoint(i)) - kRadius);
    sumOfSmooth += std::abs(distanceToCentre(smooth->GetPoint(i)) - kRadius);
  }
  EXPECT_LT(sumOfSmooth, 0.8 * sumOfSteps);
}

TEST(ScanSurface, WhatTouchesTheBorderIsClosedThere)
{
  const LabelImage image([](double r) { return r < 5.5 ? 1 : 0; }); // wider than the image is high
  const Scan scan = readText("a.nrrd", nrrdFile(image, "raw"));
  const auto label = extractSurface(scan, ofLabel(1), "a.nrrd");
  EXPECT_TRUE(isClosed(label));
  EXPECT_GT(volumeOf(label), 400.0);
  EXPECT_TRUE(isClosed(extractSurface(scan, ofValue(0.5), "a.nrrd")));
}

TEST(ScanSurface, ValuesThatAreNoNumbersAreOutside)
{
  Scan scan = readText("a.nrrd", nrrdFile(greyBall(1.0), "raw"));
  vtkNew<vtkFloatArray> values;
  vtkDataArray* stored = scan.image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
  {
    const auto value = static_cast<float>(stored->GetComponent(i, 0));
    values->InsertNextValue(value < 0.0F ? std::numeric_limits<float>::quiet_NaN() : value);
  }
  scan.image->GetPointData()->SetScalars(values);
  const auto surface = extractSurface(scan, ofValue(100.0), "a.nrrd");
  EXPECT_TRUE(isClosed(surface));
  EXPECT_NEAR(volumeOf(surface), 268.0, 8.0);
}

TEST(ScanSurface, NextToNanIsOutside)
{
  for (const double sign : { 1.0, -1.0 }) // bright or dark inside
  {
    Scan scan = readText("a.nrrd", nrrdFile(greyBall(sign), "raw"));
    vtkNew<vtkFloatArray> values;
    vtkDataArray* stored = scan.image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
    {
      const auto value = static_cast<float>(stored->GetComponent(i, 0));
      values->InsertNextValue(sign * stored->GetComponent(i, 0) < -50.0
          ? std::numeric_limits<float>::quiet_NaN()
          : value);
    }
    scan.image->GetPointData()->SetScalars(values);
    EXPECT_NEAR(volumeOf(extractSurface(scan, ofValue(sign * 100.0), "a.nrrd")), 268.0, 8.0);
  }
}

} // namespace
} // namespace medial::test

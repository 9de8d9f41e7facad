#include "filter_support.h"

#include "medial/local_thickness.h"

#include <gtest/gtest.h>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMedialLocalThickness.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

namespace
{

using namespace medial::test;

vtkSmartPointer<vtkMedialLocalThickness> make(vtkPolyData* mesh)
{
  auto filter = vtkSmartPointer<vtkMedialLocalThickness>::New();
  filter->SetInputData(mesh);
  filter->SetResolution(48);
  return filter;
}

// A plate of height 1.
vtkSmartPointer<vtkPolyData> plate()
{
  return boxPolyData({ 2.0, 2.0, 0.5 });
}

double component(vtkDataObject* output, const char* array, const char* name)
{
  vtkDataArray* parts = output->GetFieldData()->GetArray(array);
  for (int i = 0; parts != nullptr && i < parts->GetNumberOfComponents(); ++i)
  {
    if (std::string(parts->GetComponentName(i)) == name)
    {
      return parts->GetComponent(0, i);
    }
  }
  ADD_FAILURE() << "no " << array << " " << name;
  return 0.0;
}

} // namespace

TEST(MedialLocalThicknessFilter, DefaultsAreThoseOfTheLibrary)
{
  vtkNew<vtkMedialLocalThickness> filter;
  const medial::LocalThicknessOptions options;
  EXPECT_EQ(filter->GetNumberOfBins(), options.bins);
  EXPECT_EQ(filter->GetSide(), static_cast<int>(vtkMedialLocalThickness::INTERIOR));
  EXPECT_EQ(options.side, medial::Side::Interior);
}

TEST(MedialLocalThicknessFilter, APlateIsAsThickAsItIsHigh)
{
  auto filter = make(plate());
  ASSERT_TRUE(update(filter));
  vtkImageData* image = filter->GetOutput();
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "LocalThickness");
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 1);
  double sum = 0.0;
  vtkIdType inside = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double value = image->GetPointData()->GetScalars()->GetTuple1(i);
    const double distance = boxDistance({ 2.0, 2.0, 0.5 }, { x[0], x[1], x[2] });
    ASSERT_EQ(value > 0.0, distance < 0.0);
    if (distance < 0.0)
    {
      sum += value;
      ++inside;
    }
    if (distance < 0.0 && std::abs(x[0]) < 1.4 && std::abs(x[1]) < 1.4)
    {
      ASSERT_NEAR(value, 1.0, 0.01);
    }
  }
  EXPECT_EQ(component(image, "ThicknessDistribution", "Points"), static_cast<double>(inside));
  EXPECT_NEAR(component(image, "ThicknessDistribution", "Mean"), sum / static_cast<double>(inside),
    1e-5);
  EXPECT_NEAR(component(image, "ThicknessDistribution", "Maximum"), 1.0, 0.01);
  vtkDataArray* histogram = image->GetFieldData()->GetArray("ThicknessHistogram");
  ASSERT_NE(histogram, nullptr);
  EXPECT_EQ(histogram->GetNumberOfTuples(), 64);
  EXPECT_EQ(image->GetFieldData()->GetArray("SeparationHistogram"), nullptr);
  EXPECT_EQ(textFigure(image, "SignMethod"), "Winding");
}

TEST(MedialLocalThicknessFilter, BothSidesHaveTheirDistributions)
{
  auto filter = make(plate());
  filter->SetSideToBoth();
  filter->SetNumberOfBins(7);
  ASSERT_TRUE(update(filter));
  vtkImageData* image = filter->GetOutput();
  EXPECT_LT(image->GetScalarRange()[0], 0.0);
  EXPECT_EQ(component(image, "ThicknessDistribution", "Points") +
      component(image, "SeparationDistribution", "Points"),
    static_cast<double>(image->GetNumberOfPoints()));
  EXPECT_EQ(image->GetFieldData()->GetArray("SeparationHistogram")->GetNumberOfTuples(), 7);
}

TEST(MedialLocalThicknessFilter, RefusesBadParametersAndMeshesWithoutAnInside)
{
  auto filter = make(plate());
  expectErrorAndRecovery(
    filter, [&] { filter->SetNumberOfBins(0); }, [&] { filter->SetNumberOfBins(64); }, "0");
  expectErrorAndRecovery(
    filter, [&] { filter->SetSide(3); }, [&] { filter->SetSideToInterior(); }, "3");
  expectInvalidInput(make(squarePolyData()), "inside");
}

TEST(MedialLocalThicknessFilter, ReportsProgressAndCanBeAborted)
{
  auto filter = make(plate());
  {
    const EventLog log(filter);
    ASSERT_TRUE(update(filter));
    expectProgressToTheEnd(log);
  }
  filter->Modified();
  expectAbortLeavesNothing(filter, 3);
}

TEST(MedialLocalThicknessFilter, PartsOfTheGridAreThoseOfTheWhole)
{
  auto filter = make(plate());
  ASSERT_TRUE(update(filter));
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(filter->GetOutput());
  auto other = make(plate());
  const int part[6] = { 5, 9, 5, 9, 5, 9 };
  other->UpdateExtent(part);
  EXPECT_EQ(other->GetOutput()->GetNumberOfPoints(), 125);
  for (const int i : { 5, 7, 9 })
  {
    EXPECT_EQ(other->GetOutput()->GetScalarComponentAsDouble(i, i, i, 0),
      whole->GetScalarComponentAsDouble(i, i, i, 0));
  }
}

TEST(MedialLocalThicknessFilter, PiecesShareOutTheGrid)
{
  auto filter = make(plate());
  ASSERT_TRUE(update(filter));
  const std::array<int, 3> whole{ filter->GetOutput()->GetDimensions()[0],
    filter->GetOutput()->GetDimensions()[1], filter->GetOutput()->GetDimensions()[2] };
  vtkIdType cells = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    auto part = make(plate());
    part->UpdatePiece(piece, 3, 0);
    cells += part->GetOutput()->GetNumberOfCells();
  }
  EXPECT_EQ(cells, static_cast<vtkIdType>(whole[0] - 1) * (whole[1] - 1) * (whole[2] - 1));
}

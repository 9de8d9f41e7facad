// check_box_files AXIS.vtp [FIELD.vti]: ends with 0 when the files hold the medial axis and the
// distance field of the box in box.stl, by analytic truth.
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

constexpr double kHalfSides[3] = { 1.0, 0.75, 0.5 };
constexpr double kVoxel = 0.0361; // resolution 64 and the default padding

void require(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "not fulfilled: " << what << '\n';
    std::exit(EXIT_FAILURE);
  }
}

/// Signed distance to the box.
double boxDistance(const double x[3])
{
  double outside = 0.0;
  double inside = -kHalfSides[0];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double excess = std::abs(x[axis]) - kHalfSides[axis];
    inside = std::max(inside, excess);
    outside += std::pow(std::max(excess, 0.0), 2);
  }
  return inside > 0.0 ? std::sqrt(outside) : inside;
}

/// Difference of the distances to the two nearest faces: 0 on the axis.
double imbalance(const double x[3])
{
  std::array<double, 3> depths;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    depths[axis] = kHalfSides[axis] - std::abs(x[axis]);
  }
  // The opposite face of an axis is as near only in the middle plane.
  std::sort(depths.begin(), depths.end());
  double min = depths[1] - depths[0];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (kHalfSides[axis] - std::abs(x[axis]) == depths[0])
    {
      min = std::min(min, 2.0 * std::abs(x[axis]));
    }
  }
  return min;
}

void checkAxis(const char* file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file);
  reader->Update();
  vtkPolyData* axis = reader->GetOutput();
  require(axis->GetNumberOfPoints() > 1000, "more than 1000 points");
  require(axis->GetNumberOfPolys() > 1000, "more than 1000 polygons");
  for (const char* name :
    { "Radius", "SeparationAngle", "Lambda", "ClosestPointA", "ClosestPointB" })
  {
    require(axis->GetPointData()->HasArray(name) != 0, name);
  }
  vtkDataArray* radius = axis->GetPointData()->GetArray("Radius");
  double largestRadius = 0.0;
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    const double* x = axis->GetPoint(i);
    require(std::abs(radius->GetTuple1(i) + boxDistance(x)) < 0.02 * kVoxel, "exact radii");
    require(imbalance(x) < kVoxel, "points on the axis");
    largestRadius = std::max(largestRadius, radius->GetTuple1(i));
  }
  require(std::abs(largestRadius - kHalfSides[2]) < 0.1 * kVoxel, "a largest radius of 0.5");
  std::cout << axis->GetNumberOfPoints() << " points of the axis are right\n";
}

void checkField(const char* file)
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(file);
  reader->Update();
  vtkImageData* field = reader->GetOutput();
  require(field->GetNumberOfPoints() > 100000, "more than 100000 samples");
  vtkDataArray* distance = field->GetPointData()->GetArray("Distance");
  require(distance != nullptr, "an array Distance");
  for (vtkIdType i = 0; i < field->GetNumberOfPoints(); ++i)
  {
    require(std::abs(distance->GetTuple1(i) - boxDistance(field->GetPoint(i))) < 0.01 * kVoxel,
      "exact distances");
  }
  std::cout << field->GetNumberOfPoints() << " samples of the field are right\n";
}

} // namespace

int main(int argc, char* argv[])
{
  require(argc == 2 || argc == 3, "one or two file names");
  checkAxis(argv[1]);
  if (argc == 3)
  {
    checkField(argv[2]);
  }
}

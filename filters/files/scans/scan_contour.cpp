#include "files/scans/scan_contour.h"

#include "files/scans/image_mask.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageConstantPad.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace medial::files
{
namespace
{

// How far points stay away from voxels, in voxels: much more than floats round, and too little to
// matter.
constexpr double kDistance = 0.01;

// Flying edges of an image with a layer of outside around it.
vtkSmartPointer<vtkPolyData> flyingEdges(vtkImageData* image, double value, double outside)
{
  const int* size = image->GetDimensions();
  vtkNew<vtkImageConstantPad> padded;
  padded->SetInputData(image);
  padded->SetConstant(outside);
  padded->SetOutputWholeExtent(-1, size[0], -1, size[1], -1, size[2]);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputConnection(padded->GetOutputPort());
  edges->SetValue(0, value);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  return edges->GetOutput();
}

// Where the greatest value occurs at single voxels, their surface is nothing but points.
bool hasArea(vtkPolyData* surface)
{
  vtkPoints* points = surface->GetPoints();
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(size, corners);
    std::array<std::array<double, 3>, 3> corner{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      points->GetPoint(corners[i], corner[i].data());
    }
    if (vtkTriangle::TriangleArea(corner[0].data(), corner[1].data(), corner[2].data()) > 0.0)
    {
      return true;
    }
  }
  return false;
}

// Real numbers are compared in single precision, if they have a place there: scaled values round,
// and so do flying edges.
template <typename T>
bool isSame(T voxel, double value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    constexpr auto kMost = static_cast<double>(std::numeric_limits<float>::max());
    const auto number = static_cast<double>(voxel);
    return std::abs(number) <= kMost && std::abs(value) <= kMost
      ? static_cast<float>(number) == static_cast<float>(value)
      : number == value;
  }
  else
  {
    return static_cast<double>(voxel) == value;
  }
}

template <typename T>
bool occursIn(const T* values, vtkIdType count, double value)
{
  return std::any_of(values, values + count, [value](T voxel) { return isSame(voxel, value); });
}

// Whether a voxel has a value.
bool occurs(vtkImageData* image, double value)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const vtkIdType count = values->GetNumberOfTuples();
  bool found = false;
  switch (values->GetDataType())
  {
    vtkTemplateMacro(
      found = occursIn(static_cast<const VTK_TT*>(values->GetVoidPointer(0)), count, value));
    default:
      break; // no type of numbers
  }
  return found;
}

// Whether flying edges subtract values without losing anything; integers of 32 bits and more may
// overflow.
bool hasExactDifferences(vtkImageData* image)
{
  const vtkDataArray* values = image->GetPointData()->GetScalars();
  constexpr int kBytesOfInt = 4;
  return values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE ||
    values->GetDataTypeSize() < kBytesOfInt;
}

template <typename T>
void markFrom(const T* values, vtkIdType count, double value, unsigned char* marks)
{
  vtkSMPTools::For(0, count,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        marks[i] = static_cast<double>(values[i]) >= value ? 1 : 0;
      }
    });
}

// 1 where an image has a value or more, else 0.
vtkSmartPointer<vtkImageData> maskFrom(vtkImageData* image, double value)
{
  return maskOf(image,
    [value](const auto* values, vtkIdType count, unsigned char* marks)
    { markFrom(values, count, value, marks); });
}

// Points of a surface on the edges between voxels above a value and voxels below it.
class EdgePoints
{
public:
  // @param middles of the edges between the voxels.
  EdgePoints(vtkImageData* image, double outside, double value, vtkPoints* middles)
    : values_(image->GetPointData()->GetScalars())
    , size_{ image->GetDimensions()[0], image->GetDimensions()[1], image->GetDimensions()[2] }
    , outside_(outside)
    , value_(value)
    , middles_(middles)
  {
  }

  // Where the value is, but at least some share of the edge away from its ends.
  vtkSmartPointer<vtkPoints> awayFromVoxels(double distance) const
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(middles_->GetNumberOfPoints());
    vtkSMPTools::For(0, points->GetNumberOfPoints(),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          points->SetPoint(i, this->pointOn(i, distance).data());
        }
      });
    return points;
  }

private:
  using Voxel = std::array<int, 3>;

  std::array<double, 3> pointOn(vtkIdType edge, double distance) const
  {
    std::array<double, 3> point{};
    middles_->GetPoint(edge, point.data());
    Voxel low{};
    Voxel high{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = static_cast<int>(std::floor(point[axis]));
      high[axis] = static_cast<int>(std::ceil(point[axis]));
    }
    const double start = this->valueAt(low);
    const double share = (value_ - start) / (this->valueAt(high) - start);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] = low[axis] +
        (high[axis] - low[axis]) *
          (share >= distance ? std::min(share, 1.0 - distance) : distance); // not NaN of infinities
    }
    return point;
  }

  double valueAt(const Voxel& voxel) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (voxel[axis] < 0 || voxel[axis] >= size_[axis])
      {
        return outside_;
      }
    }
    const vtkIdType row = static_cast<vtkIdType>(voxel[2]) * size_[1] + voxel[1];
    return values_->GetComponent(row * size_[0] + voxel[0], 0);
  }

  vtkDataArray* values_;
  Voxel size_;
  double outside_;
  double value_;
  vtkPoints* middles_;
};

// The contour with points that stay some share of an edge away from voxels, computed in double
// precision.
vtkSmartPointer<vtkPolyData> contourAwayFromVoxels(vtkImageData* image, double value,
  double outside, double distance)
{
  // The mask has the same edges and triangles, with all points at the middles of edges.
  vtkSmartPointer<vtkPolyData> surface =
    flyingEdges(maskFrom(image, value), 0.5, outside >= value ? 1.0 : 0.0);
  const vtkSmartPointer<vtkPoints> middles = surface->GetPoints();
  const EdgePoints points(image, outside, value, middles);
  surface->SetPoints(points.awayFromVoxels(0.0));
  if (!hasArea(surface))
  {
    return nullptr;
  }
  surface->SetPoints(points.awayFromVoxels(distance));
  return surface;
}

} // namespace

vtkSmartPointer<vtkPolyData> contour(vtkImageData* image, double value, double outside)
{
  const bool throughVoxels = occurs(image, value);
  if (throughVoxels || !hasExactDifferences(image))
  {
    return contourAwayFromVoxels(image, value, outside, throughVoxels ? kDistance : 0.0);
  }
  const vtkSmartPointer<vtkPolyData> surface = flyingEdges(image, value, outside);
  return hasArea(surface) ? surface : nullptr;
}

} // namespace medial::files

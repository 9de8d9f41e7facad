#include "files/scans/scan_surface.h"

#include "files/file_content.h"
#include "files/scans/scan_outside.h"
#include "files/scans/thin_parts.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageConstantPad.h>
#include <vtkImageThreshold.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkReverseSense.h>
#include <vtkSMPTools.h>
#include <vtkTriangle.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <array>
#include <cmath>
#include <locale>
#include <set>
#include <sstream>
#include <string>

namespace fs = std::filesystem;

namespace medial::files
{
namespace
{

std::array<double, 2> rangeOf(vtkImageData* image)
{
  std::array<double, 2> range{};
  image->GetPointData()->GetScalars()->GetFiniteRange(range.data(), 0);
  return range;
}

// With at most six significant digits.
std::string roundedText(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

// Labels may be large: as an integer where the number is one.
std::string labelText(double label)
{
  constexpr double kEnd = 9223372036854775808.0; // of long long
  return std::floor(label) == label && std::abs(label) < kEnd
    ? std::to_string(static_cast<long long>(label))
    : roundedText(label);
}

// The values that occur, as many as a message has room for.
std::string labelsOf(vtkImageData* image)
{
  constexpr std::size_t kMost = 20;
  vtkDataArray* values = image->GetPointData()->GetScalars();
  std::set<double> labels;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples() && labels.size() <= kMost; ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (!std::isnan(value)) // which would have no place in the order
    {
      labels.insert(value);
    }
  }
  std::string list;
  std::size_t listed = 0;
  for (const double label : labels)
  {
    if (++listed > kMost)
    {
      return list + " and others";
    }
    list += (list.empty() ? "" : ", ") + labelText(label);
  }
  return list.empty() ? "none" : list;
}

// Whether voxels of an image can have a label. If they cannot, vtkImageThreshold would take
// the nearest label that they can have.
bool canHave(vtkImageData* image, long long label)
{
  const auto value = static_cast<double>(label);
  return image->GetScalarTypeMin() <= value && value <= image->GetScalarTypeMax();
}

// Flying edges of an image with a layer of outside around it.
vtkSmartPointer<vtkPolyData> contour(vtkImageData* image, double value, double outside)
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

vtkSmartPointer<vtkImageData> maskOf(vtkImageData* image, long long label)
{
  vtkNew<vtkImageThreshold> mask;
  mask->SetInputData(image);
  mask->ThresholdBetween(static_cast<double>(label), static_cast<double>(label));
  mask->SetInValue(1.0);
  mask->SetOutValue(0.0);
  mask->SetOutputScalarTypeToUnsignedChar();
  mask->Update();
  return mask->GetOutput();
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

vtkSmartPointer<vtkPolyData> smoothed(vtkPolyData* surface, int iterations)
{
  if (iterations == 0)
  {
    return surface;
  }
  constexpr double kPassBand = 0.1;
  vtkNew<vtkWindowedSincPolyDataFilter> filter;
  filter->SetInputData(surface);
  filter->SetNumberOfIterations(iterations);
  filter->SetPassBand(kPassBand);
  filter->BoundarySmoothingOff();
  filter->FeatureEdgeSmoothingOff();
  filter->NonManifoldSmoothingOn();
  filter->NormalizeCoordinatesOn();
  filter->Update();
  return filter->GetOutput();
}

// Moves points of parts and gaps of a mask that are one voxel wide back to where they were.
// @param steps the surface before smoothing: each point halfway between two voxels.
void restoreThinParts(vtkImageData* mask, vtkPolyData* steps, vtkPolyData* smooth)
{
  const int* size = mask->GetDimensions();
  const ThinParts parts(static_cast<const unsigned char*>(mask->GetScalarPointer()),
    { size[0], size[1], size[2] });
  vtkPoints* original = steps->GetPoints();
  vtkPoints* moved = smooth->GetPoints();
  vtkSMPTools::For(0, original->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double point[3];
        original->GetPoint(i, point);
        ThinParts::Voxel low{};
        ThinParts::Voxel high{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          low[axis] = static_cast<int>(std::floor(point[axis]));
          high[axis] = static_cast<int>(std::ceil(point[axis]));
        }
        if (parts.contains(low) || parts.contains(high))
        {
          moved->SetPoint(i, point);
        }
      }
    });
  moved->Modified();
}

vtkSmartPointer<vtkPolyData> insideOut(vtkPolyData* surface)
{
  vtkNew<vtkReverseSense> turned;
  turned->SetInputData(surface);
  turned->Update();
  return turned->GetOutput();
}

vtkSmartPointer<vtkPolyData> inPhysicalSpace(vtkPolyData* surface, const ScanFrame& frame)
{
  vtkPoints* voxels = surface->GetPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(voxels->GetNumberOfPoints());
  vtkSMPTools::For(0, voxels->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double voxel[3];
        double point[3];
        voxels->GetPoint(i, voxel);
        for (std::size_t row = 0; row < 3; ++row)
        {
          point[row] = frame[row][0] * voxel[0] + frame[row][1] * voxel[1] +
            frame[row][2] * voxel[2] + frame[row][3];
        }
        points->SetPoint(i, point);
      }
    });
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->SetPoints(points);
  moved->SetPolys(surface->GetPolys());
  return voxelVolume(frame) > 0.0 ? moved : insideOut(moved);
}

[[noreturn]] void refuse(const std::string& why)
{
  throw Error(ErrorCode::InvalidInput, why);
}

vtkSmartPointer<vtkPolyData> surfaceOfLabel(vtkImageData* image, long long label, int iterations)
{
  vtkSmartPointer<vtkPolyData> steps;
  vtkSmartPointer<vtkImageData> mask;
  if (canHave(image, label))
  {
    mask = maskOf(image, label);
    steps = contour(mask, 0.5, 0.0);
  }
  if (steps == nullptr || steps->GetNumberOfPolys() == 0)
  {
    refuse("has no voxel with the label " + std::to_string(label) +
      "; those that occur: " + labelsOf(image));
  }
  vtkSmartPointer<vtkPolyData> surface = smoothed(steps, iterations);
  if (iterations > 0)
  {
    restoreThinParts(mask, steps, surface);
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> surfaceOfValue(vtkImageData* image, double value, int iterations)
{
  const std::string missing = "has no surface at the isovalue " + roundedText(value);
  const auto [low, high] = rangeOf(image);
  const std::string range =
    ": its values are in [" + roundedText(low) + ", " + roundedText(high) + "]";
  if (!(low < value && value <= high))
  {
    refuse(missing + range);
  }
  const bool isBright = isOutsideBelow(image, value);
  const double outside = isBright ? low : high;
  replaceNan(image, outside);
  const vtkSmartPointer<vtkPolyData> raw = contour(image, value, outside);
  if (!hasArea(raw))
  {
    refuse(missing + range);
  }
  const vtkSmartPointer<vtkPolyData> surface = smoothed(raw, iterations);
  return isBright ? surface : insideOut(surface); // its normals lead to lower values
}

} // namespace

int ScanSurface::iterations() const
{
  return smoothing.value_or(label ? kOfLabels : kOfGreyValues);
}

vtkSmartPointer<vtkPolyData> extractSurface(const Scan& scan, const ScanSurface& wanted,
  const fs::path& path)
{
  return withName(path,
    [&]
    {
      const vtkSmartPointer<vtkPolyData> surface = wanted.label
        ? surfaceOfLabel(scan.image, *wanted.label, wanted.iterations())
        : surfaceOfValue(scan.image, wanted.isovalue.value(), wanted.iterations());
      return inPhysicalSpace(surface, scan.frame);
    });
}

} // namespace medial::files

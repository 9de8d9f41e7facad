#include "files/scans/scan_surface.h"

#include "files/file_content.h"
#include "files/scans/number_text.h"
#include "files/scans/scan_contour.h"
#include "files/scans/scan_labels.h"
#include "files/scans/scan_outside.h"
#include "files/scans/thin_parts.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkReverseSense.h>
#include <vtkSMPTools.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <array>
#include <cmath>
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
  const vtkSmartPointer<vtkImageData> mask = maskOfLabel(image, label);
  const vtkSmartPointer<vtkPolyData> steps = contour(mask, 0.5, 0.0);
  if (steps == nullptr)
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
  if (low > high)
  {
    refuse(missing + ": none of its values is a finite number");
  }
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
  if (raw == nullptr)
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

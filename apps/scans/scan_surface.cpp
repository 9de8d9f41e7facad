#include "scan_surface.h"

#include "input/input_file.h"
#include "input/surface_reader.h"
#include "number_text.h"

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
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

std::array<double, 2> rangeOf(vtkImageData* image)
{
  std::array<double, 2> range{};
  image->GetPointData()->GetScalars()->GetFiniteRange(range.data(), 0);
  return range;
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
    list += (list.empty() ? "" : ", ") + roundedText(label);
  }
  return list.empty() ? "none" : list;
}

// Whether voxels of an image can have a label. vtkImageThreshold takes the nearest one that they
// can have instead.
bool canHave(vtkImageData* image, long long label)
{
  const auto value = static_cast<double>(label);
  return image->GetScalarTypeMin() <= value && value <= image->GetScalarTypeMax();
}

// Whether most voxels on the border of an image have values below a threshold.
bool isBorderBelow(vtkImageData* image, double threshold)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const int* size = image->GetDimensions();
  vtkIdType below = 0;
  vtkIdType all = 0;
  vtkIdType i = 0;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      const bool row = z == 0 || z == size[2] - 1 || y == 0 || y == size[1] - 1;
      for (int x = 0; x < size[0]; ++x, ++i)
      {
        if (row || x == 0 || x == size[0] - 1)
        {
          const double value = values->GetComponent(i, 0);
          all += std::isnan(value) ? 0 : 1;
          below += value < threshold ? 1 : 0;
        }
      }
    }
  }
  return 2 * below >= all;
}

// Values that are no numbers are outside.
void replaceNan(vtkImageData* image, double outside)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  if (values->GetDataType() != VTK_FLOAT && values->GetDataType() != VTK_DOUBLE)
  {
    return;
  }
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    if (std::isnan(values->GetComponent(i, 0)))
    {
      values->SetComponent(i, 0, outside);
    }
  }
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

vtkSmartPointer<vtkPolyData> contourOfLabel(vtkImageData* image, long long label)
{
  vtkNew<vtkImageThreshold> mask;
  mask->SetInputData(image);
  mask->ThresholdBetween(static_cast<double>(label), static_cast<double>(label));
  mask->SetInValue(1.0);
  mask->SetOutValue(0.0);
  mask->SetOutputScalarTypeToUnsignedChar();
  mask->Update();
  return contour(mask->GetOutput(), 0.5, 0.0);
}

vtkSmartPointer<vtkPolyData> smoothed(vtkPolyData* surface, int iterations)
{
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
  if (voxelVolume(frame) > 0.0)
  {
    return moved;
  }
  vtkNew<vtkReverseSense> turned;
  turned->SetInputData(moved);
  turned->Update();
  return turned->GetOutput();
}

} // namespace

int ScanSurface::iterations() const
{
  return smoothing.value_or(label ? kOfLabels : kOfGreyValues);
}

vtkSmartPointer<vtkPolyData> extractSurface(const Scan& scan, const ScanSurface& wanted,
  const fs::path& path)
{
  vtkSmartPointer<vtkPolyData> surface;
  if (wanted.label)
  {
    if (canHave(scan.image, *wanted.label))
    {
      surface = contourOfLabel(scan.image, *wanted.label);
    }
    if (surface == nullptr || surface->GetNumberOfPolys() == 0)
    {
      refuseFile(path,
        "has no voxel with the label " + std::to_string(*wanted.label) +
          "; those that occur: " + labelsOf(scan.image));
    }
  }
  else
  {
    const double value = wanted.isovalue.value();
    const auto [low, high] = rangeOf(scan.image);
    if (!(low < value && value <= high))
    {
      refuseFile(path,
        "has no surface at the isovalue " + roundedText(value) + ": its values are in [" +
          roundedText(low) + ", " + roundedText(high) + "]");
    }
    const double outside = isBorderBelow(scan.image, value) ? low : high;
    replaceNan(scan.image, outside);
    surface = contour(scan.image, value, outside);
    if (surface->GetNumberOfPolys() == 0)
    {
      refuseFile(path, "has no surface at the isovalue " + roundedText(value));
    }
  }
  if (wanted.iterations() > 0)
  {
    surface = smoothed(surface, wanted.iterations());
  }
  return inPhysicalSpace(surface, scan.frame);
}

Surface readSurface(const fs::path& path, const ScanSurface& wanted)
{
  return isScanFile(path) ? Surface(extractSurface(readScan(path), wanted, path))
                          : readSurface(path);
}

Sequence readSequence(const std::vector<fs::path>& inputs, const ScanSurface& wanted)
{
  return readSequence(inputs, [&](const fs::path& path) { return readSurface(path, wanted); });
}

} // namespace medial::app

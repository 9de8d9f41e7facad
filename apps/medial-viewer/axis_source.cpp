#include "axis_source.h"

#include "library_calls.h"

#include "medial/common/stopwatch.h"

#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkGeometryFilter.h>
#include <vtkMeshConversion.h>
#include <vtkPointData.h>
#include <vtkThreshold.h>

#include <optional>
#include <utility>

namespace medial::app
{
namespace
{

MedialAxisOptions optionsOf(const ViewerOptions& options)
{
  MedialAxisOptions result;
  result.angle = kLeastViewerAngle;
  result.side = options.side;
  result.field.evaluator = options.evaluator;
  result.field.threads = options.threads;
  result.field.requireHardware = options.requireGpu;
  return result;
}

MedialSolver solverFor(const Sequence& sequence, const std::filesystem::path& input)
{
  std::optional<MedialSolver> solver;
  withFailures(input, [&] { solver.emplace(sequence.mesh); });
  return std::move(*solver);
}

void addThickness(vtkPolyData* axis)
{
  vtkDataArray* radius = axis->GetPointData()->GetArray("Radius");
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName("Thickness");
  thickness->SetNumberOfValues(axis->GetNumberOfPoints());
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    thickness->SetValue(i, static_cast<float>(2.0 * radius->GetTuple1(i)));
  }
  axis->GetPointData()->AddArray(thickness);
}

} // namespace

AxisSource::AxisSource(const Sequence& sequence, const ViewerOptions& options)
  : solver_(solverFor(sequence, options.inputs.front()))
  , options_(optionsOf(options))
  , bounds_(sequence.bounds)
  , input_(options.inputs.front())
{
}

// The grid of a resolution; field_ becomes its image.
Grid AxisSource::layOut(int resolution)
{
  const Grid grid = makeGrid(bounds_, resolution);
  if (resolution != resolution_)
  {
    field_->Initialize();
    resolution_ = 0;
    arrays_ = vtkMeshConversion::AllocateField(field_, grid, grid.wholeExtent(),
      { false, false, false, false });
    resolution_ = resolution;
  }
  return grid;
}

void AxisSource::compute(const Frame& frame, int resolution)
{
  seconds_ = 0.0;
  const Stopwatch watch(seconds_);
  withFailures(input_,
    [&]
    {
      const Grid grid = layOut(resolution);
      solver_.setPoints(frame.points);
      const MedialAxis axis = solver_.computeAxis(grid, options_, arrays_);
      vtkNew<vtkPolyData> computed;
      vtkMeshConversion::ToPolyData(axis, computed);
      addThickness(computed);
      axis_->ShallowCopy(computed);
      statistics_ = axis.statistics;
      sign_ = axis.sign;
    });
  field_->GetPointData()->GetScalars()->Modified();
  field_->Modified();
}

void selectByAngle(vtkPolyData* axis, double angle, vtkPolyData* selected)
{
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(axis);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
    "SeparationAngle");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(angle);
  threshold->AllScalarsOn();
  vtkNew<vtkGeometryFilter> cells; // as a vtkPolyData again
  cells->SetInputConnection(threshold->GetOutputPort());
  cells->Update();
  selected->ShallowCopy(cells->GetOutput());
}

} // namespace medial::app

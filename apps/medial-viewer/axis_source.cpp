#include "axis_source.h"

#include "library_calls.h"
#include "timer.h"

#include "medial/skeleton.h"

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

MedialAxisOptions optionsOf(const ViewerOptions& options, Progress* progress)
{
  MedialAxisOptions result;
  result.angle = 0.0;
  result.side = options.side;
  result.field.engine = options.engine;
  result.field.device = options.device.name;
  result.field.execution.threads = options.threads;
  result.field.requireHardware = options.device.require;
  result.field.verify = options.device.verify;
  result.field.execution.progress = progress;
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

AxisSource::AxisSource(const Sequence& sequence, const ViewerOptions& options, Progress* progress)
  : solver_(solverFor(sequence, options.inputs.front()))
  , options_(optionsOf(options, progress))
  , bounds_(sequence.bounds)
  , input_(options.inputs.front())
{
}

void AxisSource::compute(const Frame& frame, int resolution, double angle)
{
  const Timer timer;
  vtkNew<vtkImageData> field;
  vtkNew<vtkPolyData> axis;
  MedialAxisOptions options = options_;
  options.angle = angle;
  withFailures(input_,
    [&]
    {
      const Grid grid = makeGrid(bounds_, resolution);
      const FieldArrays arrays = vtkMeshConversion::AllocateField(field, grid, grid.wholeExtent(),
        { false, false, false, false });
      solver_.setPoints(frame.points);
      const MedialAxis computed = solver_.computeAxis(grid, options, arrays);
      vtkMeshConversion::ToPolyData(computed, axis);
      addThickness(axis);
      statistics_ = computed.statistics;
      sign_ = computed.sign;
    });
  const double seconds = timer.seconds();
  axis_->ShallowCopy(axis);
  field_->ShallowCopy(field);
  seconds_ = seconds;
  resolution_ = resolution;
  options_ = options;
}

void AxisSource::computeSkeleton(const Frame& frame)
{
  MedialAxisOptions options = options_;
  options.angle = kDefaultAngle;
  options.side = Side::Interior;
  options.topology = Topology::Preserve;
  vtkNew<vtkPolyData> skeleton;
  withFailures(input_,
    [&]
    {
      solver_.setPoints(frame.points);
      const MedialAxis axis = solver_.computeAxis(makeGrid(bounds_, resolution_), options);
      SkeletonOptions ofBranches;
      ofBranches.execution = options.field.execution;
      vtkMeshConversion::ToPolyData(medial::computeSkeleton(axis, solver_.mesh(), ofBranches),
        skeleton);
    });
  skeleton_->ShallowCopy(skeleton);
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

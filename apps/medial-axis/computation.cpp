#include "computation.h"

#include "failure.h"
#include "interrupt.h"

#include "medial/common/error.h"
#include "medial/common/progress.h"

#include <vtkMeshConversion.h>

#include <functional>
#include <string>
#include <utility>

namespace medial::app
{
namespace
{

// Forwards progress to the terminal, and the user's wish to stop to the library.
class Watch : public Progress
{
public:
  explicit Watch(ProgressBar& bar)
    : bar_(bar)
  {
  }

  void report(double fraction, const char* phase) override { bar_.show(fraction, phase); }
  bool cancelled() override { return interrupted(); }

private:
  ProgressBar& bar_;
};

ExitCode exitCodeOf(ErrorCode code)
{
  switch (code)
  {
    case ErrorCode::InvalidInput:
      return ExitCode::BadInput;
    case ErrorCode::NoGpu:
    case ErrorCode::ShaderBuild:
      return ExitCode::NoGpu;
    case ErrorCode::Cancelled:
      return ExitCode::Interrupted;
    case ErrorCode::GpuLimit:
    case ErrorCode::OutOfMemory:
      break;
  }
  return ExitCode::NoSpace;
}

// Turns the library's errors into failures of the program.
void withFailures(const Options& options, const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    throwIfInterrupted();
    const ExitCode code = exitCodeOf(error.code());
    const std::string culprit = code == ExitCode::NoGpu ? "" : options.input.string() + ": ";
    throw Failure(code, culprit + error.what());
  }
}

Grid gridOf(const Bounds& bounds, const Options& options)
{
  if (options.spacing)
  {
    const double spacing = *options.spacing;
    return makeGridWithSpacing(bounds, { spacing, spacing, spacing }, options.padding);
  }
  return makeGrid(bounds, options.resolution, options.padding);
}

void computeField(const DistanceFieldOptions& options, FieldSink& field, Result& result)
{
  result.statistics = computeDistanceField(result.mesh, result.topology, result.grid,
    result.grid.wholeExtent(), field, options);
  result.sign = resolveSignMethod(options.sign, result.topology);
}

void computeAxis(const MedialAxisOptions& options, bool reported, FieldSink* field, Result& result)
{
  const MedialAxis axis = field != nullptr
    ? computeMedialAxis(result.mesh, result.topology, result.grid, options, *field)
    : computeMedialAxis(result.mesh, result.topology, result.grid, options);
  vtkMeshConversion::ToPolyData(axis, result.axis);
  result.statistics = axis.statistics;
  result.sign = axis.sign;
  result.side = axis.side;
  result.solidTopology = axis.solid;
  if (reported)
  {
    result.axisTopology = topologyOf(axis);
  }
}

} // namespace

Result prepare(vtkPolyData* mesh, const Options& options)
{
  Result result;
  withFailures(options,
    [&]
    {
      result.axis = vtkSmartPointer<vtkPolyData>::New();
      result.mesh = buildTriangleMesh(vtkMeshConversion::ToMeshInput(mesh));
      result.topology = analyseTopology(result.mesh);
      result.grid = gridOf(result.mesh.bounds(), options);
    });
  return result;
}

void compute(const Options& options, FieldSink* field, ProgressBar& bar, Result& result)
{
  Watch watch(bar);
  MedialAxisOptions wanted = libraryOptions(options, result.mesh.bounds().diagonal());
  wanted.field.progress = &watch;
  withFailures(options,
    [&]
    {
      if (options.wantsAxis() || field == nullptr)
      {
        computeAxis(wanted, !options.report.empty(), field, result);
      }
      else
      {
        computeField(wanted.field, *field, result);
      }
    });
  throwIfInterrupted();
}

} // namespace medial::app

#include "run.h"

#include "axis_writer.h"
#include "failure.h"
#include "interrupt.h"
#include "mesh_reader.h"
#include "output_file.h"
#include "picture.h"
#include "progress_bar.h"
#include "report.h"
#include "summary.h"
#include "vtk_messages.h"

#include <vtkCommand.h>
#include <vtkMedialAxis.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <chrono>
#include <functional>
#include <list>
#include <string>

namespace medial::app
{
namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Forwards the filter's progress to the terminal, and the user's wish to stop to the filter.
class FilterWatch
{
public:
  FilterWatch(vtkMedialAxis* filter, ProgressBar& bar)
    : filter_(filter)
    , bar_(bar)
  {
    filter->AddObserver(vtkCommand::ProgressEvent, this, &FilterWatch::onProgress);
  }

private:
  void onProgress()
  {
    const char* phase = filter_->GetProgressText();
    bar_.show(filter_->GetProgress(), phase != nullptr ? phase : "computing");
    if (interrupted())
    {
      filter_->SetAbortExecute(1);
    }
  }

  vtkMedialAxis* filter_;
  ProgressBar& bar_;
};

ExitCode exitCodeOf(unsigned long filterError)
{
  switch (filterError)
  {
    case vtkMedialAxis::InvalidInputError:
      return ExitCode::BadInput;
    case vtkMedialAxis::NoGpuError:
    case vtkMedialAxis::ShaderBuildError:
      return ExitCode::NoGpu;
    case vtkMedialAxis::CancelledError:
      return ExitCode::Interrupted;
    default:
      return ExitCode::NoSpace;
  }
}

void execute(vtkMedialAxis* filter, const Options& options, ProgressBar& bar)
{
  const FilterWatch watch(filter, bar);
  const VtkMessages messages;
  filter->Update();
  filter->RemoveObservers(vtkCommand::ProgressEvent);
  throwIfInterrupted();
  if (filter->GetErrorCode() != 0)
  {
    const ExitCode code = exitCodeOf(filter->GetErrorCode());
    const std::string culprit = code == ExitCode::NoGpu ? "" : options.input.string() + ": ";
    throw Failure(code, culprit + messages.first());
  }
}

// The outputs of a run: checked before it starts, given their names when it is over.
class Outputs
{
public:
  using Write = std::function<void(const std::filesystem::path&)>;

  void add(const std::filesystem::path& path, Write write)
  {
    if (!path.empty())
    {
      entries_.emplace_back(path, std::move(write));
    }
  }

  void write()
  {
    for (Entry& entry : entries_)
    {
      throwIfInterrupted();
      try
      {
        entry.write(entry.file.open());
      }
      catch (const Failure& failure)
      {
        throw Failure(failure.exitCode(),
          entry.file.path().string() + ": cannot be written: " + failure.what());
      }
    }
    throwIfInterrupted();
  }

  void commit()
  {
    for (Entry& entry : entries_)
    {
      entry.file.commit();
    }
  }

private:
  struct Entry
  {
    Entry(const std::filesystem::path& path, Write function)
      : file(path)
      , write(std::move(function))
    {
    }

    OutputFile file;
    Write write;
  };

  std::list<Entry> entries_;
};

} // namespace

void run(const Options& options)
{
  const Clock::time_point start = Clock::now();
  vtkNew<vtkMedialAxis> filter;
  vtkSmartPointer<vtkPolyData> mesh;
  AppSeconds seconds;
  Clock::time_point writeStart;

  Outputs outputs;
  outputs.add(options.output,
    [&](const auto& file) { writeAxis(filter->GetOutput(), file, options.output.extension()); });
  outputs.add(options.field,
    [&](const auto& file) { writeField(filter->GetDistanceField(), file); });
  outputs.add(options.image,
    [&](const auto& file) { drawPicture(mesh, filter->GetOutput(), file); });
  outputs.add(options.report,
    [&](const auto& file)
    {
      seconds.write = secondsSince(writeStart);
      seconds.total = secondsSince(start);
      writeReport(makeReport(filter, options.input, seconds), file);
    });

  ProgressBar bar(options.quiet);
  if (options.threads > 0)
  {
    vtkSMPTools::Initialize(options.threads);
  }
  bar.show(0.0, "reading");
  mesh = readMesh(options.input);
  seconds.read = secondsSince(start);
  throwIfInterrupted();

  applyOptions(options, filter);
  filter->SetInputDataObject(mesh);
  execute(filter, options, bar);

  writeStart = Clock::now();
  bar.show(1.0, "writing");
  outputs.write();
  outputs.commit();
  seconds.write = secondsSince(writeStart);
  seconds.total = secondsSince(start);
  bar.clear();
  if (!options.quiet)
  {
    printSummary(options, filter, seconds);
  }
}

} // namespace medial::app

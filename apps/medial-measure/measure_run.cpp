#include "measure_run.h"

#include "input/model_reader.h"
#include "input/surface_reader.h"
#include "interrupt.h"
#include "library_calls.h"
#include "measure_report.h"
#include "output/file_writer.h"
#include "output/json_output.h"
#include "output/output_files.h"
#include "progress_bar.h"
#include "timer.h"

namespace medial::app
{
namespace
{

MedialModel readInputs(const MeasureCommand& command, ProgressBar& bar, MeasureResults& results)
{
  const Timer timer;
  MedialModel model = readModel(command.axis);
  const Surface surface = readSurface(command.mesh);
  Watch watch(bar);
  withFailures(command.mesh,
    [&]
    {
      results.mesh = surface.toTriangleMesh();
      results.connectivity = analyseConnectivity(results.mesh, { command.threads, &watch });
    });
  results.readSeconds = timer.seconds();
  throwIfInterrupted();
  return model;
}

void measure(const MeasureCommand& command, const MedialModel& model, ProgressBar& bar,
  MeasureResults& results)
{
  const Timer timer;
  Watch watch(bar);
  MeasurementOptions options;
  options.samples = command.samples;
  options.execution.threads = command.threads;
  options.execution.progress = &watch;
  withFailures(command.mesh,
    [&] { results.measurement = measureAxis(results.mesh, results.connectivity, model, options); });
  results.measureSeconds = timer.seconds();
}

} // namespace

void runMeasure(const MeasureCommand& command)
{
  OutputFiles files;
  files.add(command.json); // refused before anything is read if it cannot be written
  ProgressBar bar(command.quiet);
  bar.show(0.0, "reading");
  MeasureResults results;
  const MedialModel model = readInputs(command, bar, results);
  measure(command, model, bar, results);
  bar.clear();
  const auto json = [&] { return makeJson(command, results); };
  files.write(command.json, [&](const auto& file) { writeFile(file, json()); });
  files.commit();
  printResult(command.json, command.quiet, json, [&] { printTable(command, results); });
}

} // namespace medial::app

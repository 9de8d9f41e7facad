#include "measure_run.h"

#include "axis_reader.h"
#include "interrupt.h"
#include "library_calls.h"
#include "measure_report.h"
#include "mesh_reader.h"
#include "output_file.h"
#include "progress_bar.h"
#include "sink.h"

#include "base/stopwatch.h"

#include <vtkMedialModelConversion.h>
#include <vtkMeshConversion.h>

#include <optional>

namespace medial::app
{
namespace
{

// Errors of the axis and of the mesh name the file at fault.
MeasureResult measure(const MeasureOptions& options, ProgressBar& bar)
{
  MeasureResult result;
  MedialModel model;
  timed(result.readSeconds,
    [&]
    {
      bar.show(0.0, "reading");
      const auto axis = readAxis(options.axis);
      withFailures(options.axis, [&] { model = vtkMedialModelConversion::ToMedialModel(axis); });
      const auto mesh = readMesh(options.mesh);
      withFailures(options.mesh,
        [&]
        {
          result.mesh = buildTriangleMesh(vtkMeshConversion::ToMeshInput(mesh));
          result.connectivity = analyseConnectivity(result.mesh);
        });
    });
  throwIfInterrupted();
  timed(result.measureSeconds,
    [&]
    {
      Watch watch(bar);
      MeasurementOptions wanted;
      wanted.samples = options.samples;
      wanted.execution.threads = options.threads;
      wanted.execution.progress = &watch;
      withFailures(options.mesh,
        [&] { result.measurement = measureAxis(result.mesh, result.connectivity, model, wanted); });
    });
  return result;
}

void writeJson(const std::string& json, OutputFile& file)
{
  namingFile(file.path(),
    [&]
    {
      Sink sink(file.open());
      sink << json.c_str();
      sink.close();
    });
  throwIfInterrupted();
  file.commit();
}

} // namespace

void runMeasure(const MeasureOptions& options)
{
  std::optional<OutputFile> json;
  if (!options.json.empty())
  {
    json.emplace(options.json);
  }
  ProgressBar bar(options.quiet);
  const MeasureResult result = measure(options, bar);
  bar.clear();
  if (json)
  {
    writeJson(makeJson(options, result), *json);
  }
  if (!options.quiet)
  {
    printTable(options, result);
  }
}

} // namespace medial::app

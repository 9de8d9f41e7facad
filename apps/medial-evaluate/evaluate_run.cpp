#include "evaluate_run.h"

#include "axis_reader.h"
#include "evaluate_report.h"
#include "interrupt.h"
#include "library_calls.h"
#include "mesh_reader.h"
#include "output_file.h"
#include "progress_bar.h"
#include "sink.h"

#include "medial/common/stopwatch.h"

#include <vtkMedialModelConversion.h>
#include <vtkMeshConversion.h>

#include <optional>

namespace medial::app
{
namespace
{

// Errors of the axis and of the mesh name the file at fault.
EvaluateResult evaluate(const EvaluateOptions& options, ProgressBar& bar)
{
  EvaluateResult result;
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
          result.topology = analyseTopology(result.mesh);
        });
    });
  throwIfInterrupted();
  timed(result.evaluateSeconds,
    [&]
    {
      Watch watch(bar);
      EvaluationOptions wanted;
      wanted.samples = options.samples;
      wanted.threads = options.threads;
      wanted.progress = &watch;
      withFailures(options.mesh,
        [&] { result.evaluation = evaluateAxis(result.mesh, result.topology, model, wanted); });
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

void runEvaluation(const EvaluateOptions& options)
{
  std::optional<OutputFile> json;
  if (!options.json.empty())
  {
    json.emplace(options.json);
  }
  ProgressBar bar(options.quiet);
  const EvaluateResult result = evaluate(options, bar);
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

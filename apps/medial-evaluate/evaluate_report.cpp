#include "evaluate_report.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace medial::app
{
namespace
{

using Json = nlohmann::ordered_json;

double percent(double length, const AxisEvaluation& evaluation)
{
  return 100.0 * length / evaluation.diagonal;
}

long long eulerCharacteristic(const EvaluateResult& result)
{
  return static_cast<long long>(result.mesh.points.size()) -
    static_cast<long long>(result.topology.edges.size()) +
    static_cast<long long>(result.mesh.triangles.size());
}

double insideShare(const AxisEvaluation& evaluation)
{
  return static_cast<double>(evaluation.centresInside) /
    static_cast<double>(evaluation.topology.points);
}

const char* plural(long long count)
{
  return count == 1 ? "" : "s";
}

void printCounts(const EvaluateOptions& options, const EvaluateResult& result)
{
  const ModelTopology& axis = result.evaluation.topology;
  std::printf("axis      %s: %lld points, %lld quads, %lld triangles, %lld lines, %lld vertices\n",
    options.axis.c_str(), static_cast<long long>(axis.points), static_cast<long long>(axis.quads),
    static_cast<long long>(axis.triangles), static_cast<long long>(axis.lines),
    static_cast<long long>(axis.vertices));
  std::printf("          %lld component%s, Euler characteristic %lld, %lld cell%s without area\n",
    static_cast<long long>(axis.components), plural(axis.components),
    static_cast<long long>(axis.eulerCharacteristic), static_cast<long long>(axis.zeroAreaCells),
    plural(axis.zeroAreaCells));
  const long long components = result.topology.components;
  std::printf("mesh      %s: %zu triangles, %zu vertices, %s\n", options.mesh.c_str(),
    result.mesh.triangles.size(), result.mesh.points.size(),
    result.topology.closed() ? "closed" : "not closed");
  std::printf("          %lld component%s, Euler characteristic %lld, diagonal %.6g\n\n",
    components, plural(components), eulerCharacteristic(result), result.evaluation.diagonal);
}

void printRow(const char* name, const Deviation& deviation, const AxisEvaluation& evaluation)
{
  std::printf("%-24s %10.5f %10.5f %10lld\n", name, percent(deviation.max, evaluation),
    percent(deviation.mean, evaluation), static_cast<long long>(deviation.places));
}

Json describe(const Deviation& deviation, const AxisEvaluation& evaluation)
{
  return { { "max", percent(deviation.max, evaluation) },
    { "mean", percent(deviation.mean, evaluation) }, { "samples", deviation.places } };
}

Json describeAxis(const EvaluateOptions& options, const ModelTopology& axis)
{
  return { { "path", options.axis.string() }, { "points", axis.points }, { "quads", axis.quads },
    { "triangles", axis.triangles }, { "lines", axis.lines }, { "vertices", axis.vertices },
    { "zero_area_cells", axis.zeroAreaCells }, { "components", axis.components },
    { "euler_characteristic", axis.eulerCharacteristic } };
}

Json describeMesh(const EvaluateOptions& options, const EvaluateResult& result)
{
  return { { "path", options.mesh.string() }, { "triangles", result.mesh.triangles.size() },
    { "vertices", result.mesh.points.size() }, { "closed", result.topology.closed() },
    { "manifold", result.topology.manifold() }, { "components", result.topology.components },
    { "euler_characteristic", eulerCharacteristic(result) },
    { "diagonal", result.evaluation.diagonal } };
}

} // namespace

void printTable(const EvaluateOptions& options, const EvaluateResult& result)
{
  const AxisEvaluation& evaluation = result.evaluation;
  printCounts(options, result);
  std::printf("%-24s %10s %10s %10s\n", "% of the diagonal", "max", "mean", "samples");
  printRow("surface to union", evaluation.surfaceToUnion, evaluation);
  printRow("union to surface", evaluation.unionToSurface, evaluation);
  std::printf("%-24s %10.5f %10.5f\n", "two-sided", percent(evaluation.hausdorff(), evaluation),
    percent(evaluation.meanDistance(), evaluation));
  printRow("radius error", evaluation.radiusError, evaluation);
  if (evaluation.knowsInside)
  {
    std::printf("\ncentres inside the mesh: %.3f %%\n", 100.0 * insideShare(evaluation));
  }
  else
  {
    std::printf("\ncentres inside the mesh: unknown, it is %s\n",
      result.topology.closed() ? "not consistently oriented" : "not closed");
  }
}

std::string makeJson(const EvaluateOptions& options, const EvaluateResult& result)
{
  const AxisEvaluation& evaluation = result.evaluation;
  Json json;
  json["axis"] = describeAxis(options, evaluation.topology);
  json["mesh"] = describeMesh(options, result);
  json["surface_to_union"] = describe(evaluation.surfaceToUnion, evaluation);
  json["union_to_surface"] = describe(evaluation.unionToSurface, evaluation);
  json["two_sided"] = { { "hausdorff", percent(evaluation.hausdorff(), evaluation) },
    { "mean", percent(evaluation.meanDistance(), evaluation) } };
  json["radius_error"] = { { "max", percent(evaluation.radiusError.max, evaluation) },
    { "mean", percent(evaluation.radiusError.mean, evaluation) } };
  json["centres_inside"] = evaluation.knowsInside ? Json(insideShare(evaluation)) : Json(nullptr);
  json["seconds"] = { { "read", result.readSeconds }, { "evaluate", result.evaluateSeconds } };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace medial::app

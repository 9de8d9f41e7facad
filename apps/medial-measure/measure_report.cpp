#include "measure_report.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace medial::app
{
namespace
{

using Json = nlohmann::ordered_json;

double percent(double length, const AxisMeasurement& measurement)
{
  return 100.0 * length / measurement.diagonal;
}

long long eulerCharacteristic(const MeasureResults& results)
{
  return static_cast<long long>(results.mesh.points.size()) -
    static_cast<long long>(results.connectivity.edges.size()) +
    static_cast<long long>(results.mesh.triangles.size());
}

double insideShare(const AxisMeasurement& measurement)
{
  return static_cast<double>(measurement.centresInside) /
    static_cast<double>(measurement.counts.points);
}

const char* plural(long long count)
{
  return count == 1 ? "" : "s";
}

void printCounts(const MeasureCommand& command, const MeasureResults& results)
{
  const ModelCounts& axis = results.measurement.counts;
  std::printf("axis      %s: %lld points, %lld quads, %lld triangles, %lld lines, %lld vertices\n",
    command.axis.c_str(), static_cast<long long>(axis.points), static_cast<long long>(axis.quads),
    static_cast<long long>(axis.triangles), static_cast<long long>(axis.lines),
    static_cast<long long>(axis.vertices));
  std::printf("          %lld component%s, Euler characteristic %lld, %lld cell%s without area\n",
    static_cast<long long>(axis.components), plural(axis.components),
    static_cast<long long>(axis.eulerCharacteristic), static_cast<long long>(axis.zeroAreaCells),
    plural(axis.zeroAreaCells));
  const long long components = results.connectivity.components;
  std::printf("mesh      %s: %zu triangles, %zu vertices, %s\n", command.mesh.c_str(),
    results.mesh.triangles.size(), results.mesh.points.size(),
    results.connectivity.closed() ? "closed" : "not closed");
  std::printf("          %lld component%s, Euler characteristic %lld, diagonal %.6g\n\n",
    components, plural(components), eulerCharacteristic(results), results.measurement.diagonal);
}

void printRow(const char* name, const Deviation& deviation, const AxisMeasurement& measurement)
{
  std::printf("%-24s %10.5f %10.5f %10lld\n", name, percent(deviation.max, measurement),
    percent(deviation.mean, measurement), static_cast<long long>(deviation.places));
}

Json describe(const Deviation& deviation, const AxisMeasurement& measurement)
{
  return { { "max", percent(deviation.max, measurement) },
    { "mean", percent(deviation.mean, measurement) }, { "samples", deviation.places } };
}

Json describeAxis(const MeasureCommand& command, const ModelCounts& axis)
{
  return { { "path", command.axis.string() }, { "points", axis.points }, { "quads", axis.quads },
    { "triangles", axis.triangles }, { "lines", axis.lines }, { "vertices", axis.vertices },
    { "zero_area_cells", axis.zeroAreaCells }, { "components", axis.components },
    { "euler_characteristic", axis.eulerCharacteristic } };
}

Json describeMesh(const MeasureCommand& command, const MeasureResults& results)
{
  return { { "path", command.mesh.string() }, { "triangles", results.mesh.triangles.size() },
    { "vertices", results.mesh.points.size() }, { "closed", results.connectivity.closed() },
    { "manifold", results.connectivity.manifold() },
    { "components", results.connectivity.components },
    { "euler_characteristic", eulerCharacteristic(results) },
    { "diagonal", results.measurement.diagonal } };
}

} // namespace

void printTable(const MeasureCommand& command, const MeasureResults& results)
{
  const AxisMeasurement& measurement = results.measurement;
  printCounts(command, results);
  std::printf("%-24s %10s %10s %10s\n", "% of the diagonal", "max", "mean", "samples");
  printRow("surface to union", measurement.surfaceToUnion, measurement);
  printRow("union to surface", measurement.unionToSurface, measurement);
  std::printf("%-24s %10.5f %10.5f\n", "two-sided", percent(measurement.hausdorff(), measurement),
    percent(measurement.meanDistance(), measurement));
  printRow("radius error", measurement.radiusError, measurement);
  if (measurement.knowsInside)
  {
    std::printf("\ncentres inside the mesh: %.3f %%\n", 100.0 * insideShare(measurement));
  }
  else
  {
    std::printf("\ncentres inside the mesh: unknown, it is %s\n",
      results.connectivity.closed() ? "not consistently oriented" : "not closed");
  }
}

std::string makeJson(const MeasureCommand& command, const MeasureResults& results)
{
  const AxisMeasurement& measurement = results.measurement;
  Json json;
  json["axis"] = describeAxis(command, measurement.counts);
  json["mesh"] = describeMesh(command, results);
  json["surface_to_union"] = describe(measurement.surfaceToUnion, measurement);
  json["union_to_surface"] = describe(measurement.unionToSurface, measurement);
  json["two_sided"] = { { "hausdorff", percent(measurement.hausdorff(), measurement) },
    { "mean", percent(measurement.meanDistance(), measurement) } };
  json["radius_error"] = { { "max", percent(measurement.radiusError.max, measurement) },
    { "mean", percent(measurement.radiusError.mean, measurement) } };
  json["centres_inside"] = measurement.knowsInside ? Json(insideShare(measurement)) : Json(nullptr);
  json["seconds"] = { { "read", results.readSeconds }, { "evaluate", results.measureSeconds } };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace medial::app

#include "distance_report.h"

#include "option_names.h"
#include "output/standard_output.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace medial::app
{
namespace
{

using Json = nlohmann::ordered_json;

std::ptrdiff_t countInside(const DistanceResults& results)
{
  const std::vector<double>& distances = results.distances.distance;
  return std::count_if(distances.begin(), distances.end(), [](double d) { return d < 0.0; });
}

Json describe(const FarthestPoint& farthest)
{
  return { { "distance", farthest.distance }, { "bound", farthest.bound },
    { "point", farthest.point } };
}

Json describe(const SurfaceComparison& comparison)
{
  return { { "distance", comparison.hausdorff() },
    { "points_to_mesh", describe(comparison.ofPoints) },
    { "mesh_to_points", describe(comparison.ofMesh) } };
}

void printFarthest(const char* what, const FarthestPoint& farthest)
{
  std::printf("          %s %.9g, at (%.6g, %.6g, %.6g)\n", what, farthest.distance,
    farthest.point[0], farthest.point[1], farthest.point[2]);
}

} // namespace

void printTable(const DistanceCommand& command, const DistanceResults& results)
{
  std::printf("mesh      %s: %zu triangles, %zu vertices\n", command.mesh.c_str(),
    results.triangles, results.vertices);
  std::printf("sign      %s: %s\n", nameOf(results.sign.method).c_str(),
    results.sign.reason.c_str());
  std::printf("points    %s: %zu", command.points.c_str(), results.points.size());
  if (results.sign.method != SignMethod::None)
  {
    std::printf(", %td of them inside", countInside(results));
  }
  std::printf("\n");
  const DistanceSummary summary = summarise(results.distances);
  std::printf("distance  min %.9g, max %.9g; of magnitudes mean %.9g, RMS %.9g\n", summary.min,
    summary.max, summary.mean, summary.rms);
  std::printf("          median %.9g, 95 %% of them up to %.9g\n", summary.median,
    summary.percentile95);
  if (results.comparison)
  {
    std::printf("deviation mean %.9g, RMS %.9g, maximum %.9g, Hausdorff %.9g\n", summary.mean,
      summary.rms, std::max(std::abs(summary.min), std::abs(summary.max)),
      results.comparison->hausdorff());
    printFarthest("points' surface to mesh", results.comparison->ofPoints);
    printFarthest("mesh to points' surface", results.comparison->ofMesh);
  }
  std::printf("seconds   read %.2f, compute %.2f\n", results.readSeconds, results.computeSeconds);
  printFile(command.output, "distances of points");
  printFile(command.image, "picture of the distances");
  printFile(command.json, "report of the run");
}

std::string makeJson(const DistanceCommand& command, const DistanceResults& results)
{
  const DistanceSummary summary = summarise(results.distances);
  Json json;
  json["mesh"] = { { "path", command.mesh.string() }, { "triangles", results.triangles },
    { "vertices", results.vertices } };
  json["points"] = { { "path", command.points.string() }, { "count", results.points.size() } };
  json["sign"] = { { "method", nameOf(results.sign.method) }, { "reason", results.sign.reason } };
  json["distance"] = { { "min", summary.min }, { "max", summary.max }, { "mean", summary.mean },
    { "rms", summary.rms }, { "median", summary.median }, { "percentile_95", summary.percentile95 },
    { "inside",
      results.sign.method == SignMethod::None ? Json(nullptr) : Json(countInside(results)) } };
  json["hausdorff"] = results.comparison ? describe(*results.comparison) : Json(nullptr);
  json["seconds"] = { { "read", results.readSeconds }, { "compute", results.computeSeconds } };
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace medial::app

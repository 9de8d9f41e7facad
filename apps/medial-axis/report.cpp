#include "report.h"

#include "coverage_policy.h"
#include "option_names.h"
#include "output/file_writer.h"

#include "medial/version.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace medial::app
{
namespace
{

using Json = nlohmann::ordered_json;

Json describeInput(const Result& result, const std::filesystem::path& input)
{
  const MeshFigures& mesh = result.meshFigures;
  return { { "path", input.string() }, { "triangles", mesh.triangles }, { "vertices", mesh.points },
    { "closed", mesh.closed }, { "manifold", mesh.manifold }, { "components", mesh.components },
    { "skipped_degenerate", mesh.degenerateTriangles } };
}

Json describeGrid(const Grid& grid)
{
  return { { "dimensions", grid.dimensions }, { "spacing", grid.spacing },
    { "origin", grid.origin } };
}

/// All null where no engine asked for OpenGL.
Json describeDevice(const std::optional<Device>& device)
{
  Json json{ { "number", nullptr }, { "origin", nullptr }, { "renderer", nullptr },
    { "version", nullptr }, { "software", nullptr } };
  if (device)
  {
    json = { { "number", device->number }, { "origin", device->origin },
      { "renderer", device->renderer }, { "version", device->version },
      { "software", device->software } };
  }
  return json;
}

Json describeSeconds(const RunStatistics::Seconds& run, const AppSeconds& app)
{
  return { { "read", app.read }, { "prepare", app.prepare }, { "sites", run.sites },
    { "sign", run.sign }, { "cull", run.cull }, { "polygons", run.polygons }, { "draw", run.draw },
    { "resolve", run.resolve }, { "medial", run.medial }, { "measure", app.measure },
    { "skeleton", app.skeleton }, { "thickness", app.thickness }, { "pictures", app.pictures },
    { "write", app.write }, { "total", app.total } };
}

Json describeSeconds(const RunStatistics::DeviceSeconds& device)
{
  return { { "sites", device.sites }, { "cull", device.cull }, { "evaluate", device.evaluate },
    { "resolve", device.resolve }, { "select", device.select }, { "copy", device.copy },
    { "total", device.total() } };
}

// Lengths in world units, as the library took them.
Json describeParameters(const Result& result, const Options& options)
{
  const double diagonal = result.meshFigures.diagonal;
  return { { "angle", options.angle }, { "lambda", options.lambda.inUnits(diagonal) },
    { "min_radius", options.minRadius.inUnits(diagonal) }, { "side", nameOf(options.side) },
    { "representation", nameOf(options.representation) }, { "max_spheres", options.maxSpheres },
    { "topology", nameOf(options.topology) }, { "min_branch", options.minBranch },
    { "smooth", options.smooth }, { "sign", nameOf(options.signMethod) },
    { "engine", nameOf(options.engine) }, { "padding", options.padding },
    { "threads", options.threads } };
}

Json describeSign(const SignReport& sign)
{
  return { { "reason", sign.reason }, { "rim_edges", sign.rimEdges }, { "holes", sign.holes },
    { "ambiguous_share", sign.ambiguousShare }, { "lid_share", sign.lidShare },
    { "copies", sign.copies }, { "turned", sign.turned } };
}

Json describeCounts(const Result& result)
{
  const RunStatistics& statistics = result.statistics;
  return { { "sites", statistics.sites }, { "polygons", statistics.polygons },
    { "fragments", statistics.fragments }, { "group_tests", statistics.groupTests },
    { "site_tests", statistics.siteTests }, { "candidate_pairs", statistics.candidatePairs },
    { "medial_points", result.axisPoints }, { "medial_cells", result.axisCells } };
}

Json describeSimplification(const SimplificationStatistics& simplification)
{
  return { { "input_points", simplification.inputPoints },
    { "input_components", simplification.inputComponents },
    { "components", simplification.components }, { "joined", simplification.joined },
    { "forced", simplification.forced }, { "dropped", simplification.dropped },
    { "seconds", simplification.seconds } };
}

Json describeRegions(const std::vector<ThicknessRegion>& regions)
{
  Json list = Json::array();
  for (const ThicknessRegion& region : regions)
  {
    list.push_back({ { "kind", region.thin ? "thin" : "thick" }, { "area", region.area },
      { "value", region.value }, { "place", region.place }, { "cells", region.cells } });
  }
  return list;
}

// NaN becomes null.
Json describeThickness(const Result& result, const Options& options)
{
  const Thickness& thickness = *result.thickness;
  const ThicknessOptions measured = thicknessOptions(options);
  const ThicknessLimits limits = thicknessLimits(options, result.meshFigures.diagonal);
  const auto limit = [](const std::optional<double>& value)
  { return value ? Json(*value) : Json(nullptr); };
  const bool rays = measured.method == ThicknessMethod::Ray;
  return { { "method", nameOf(measured.method) }, { "side", nameOf(options.side) },
    { "angle", rays ? Json(nullptr) : Json(measured.ballAngle()) }, { "min", thickness.min },
    { "percentile_5", thickness.percentile5 }, { "median", thickness.median },
    { "percentile_95", thickness.percentile95 }, { "max", thickness.max },
    { "share_without", thickness.shareWithout() }, { "triangles", result.thicknessTriangles },
    { "min_limit", limit(limits.min) }, { "max_limit", limit(limits.max) },
    { "regions", options.hasThicknessLimits() ? describeRegions(result.regions) : Json(nullptr) },
    { "seconds", thickness.seconds } };
}

Json describe(const std::optional<LocalThicknessSummary>& summary)
{
  if (!summary)
  {
    return nullptr;
  }
  return { { "points", summary->points }, { "min", summary->min }, { "mean", summary->mean },
    { "standard_deviation", summary->standardDeviation }, { "max", summary->max },
    { "histogram", summary->histogram }, { "histogram_end", summary->end } };
}

Json describeLocalThickness(const LocalThicknessStatistics& statistics)
{
  return { { "thickness", describe(statistics.thickness) },
    { "separation", describe(statistics.separation) }, { "balls", statistics.balls },
    { "seconds", statistics.seconds } };
}

Json describe(const CellTopology& topology)
{
  return { { "components", topology.components },
    { "euler_characteristic", topology.eulerCharacteristic }, { "genus", topology.genus },
    { "cavities", topology.cavities } };
}

Json describeSkeleton(const Skeleton& skeleton)
{
  double length = 0.0;
  for (const SkeletonBranch& branch : skeleton.branches)
  {
    length += branch.length;
  }
  const CellTopology topology = topologyOf(skeleton);
  return { { "points", skeleton.points.size() }, { "branches", skeleton.branches.size() },
    { "end_junction", skeleton.count(BranchKind::EndJunction) },
    { "junction_junction", skeleton.count(BranchKind::JunctionJunction) },
    { "closed", skeleton.count(BranchKind::Closed) },
    { "isolated", skeleton.count(BranchKind::Isolated) }, { "junctions", skeleton.junctions() },
    { "components", topology.components }, { "loops", topology.genus }, { "length", length },
    { "opened_cavities", skeleton.openedCavities }, { "thinnest_radius", thinnestRadius(skeleton) },
    { "seconds", skeleton.seconds } };
}

Json describeTopology(const Result& result, Topology mode)
{
  return { { "mode", nameOf(mode) },
    { "solid", result.axis.solid ? describe(*result.axis.solid) : Json() },
    { "axis", describe(result.axisTopology) } };
}

Json describeRanks(const std::vector<RankFigures>& ranks)
{
  Json list; // null for a single process
  for (const RankFigures& rank : ranks)
  {
    list.push_back({ { "grid_points", rank.gridPoints }, { "medial_cells", rank.axisCells },
      { "own_triangles", rank.counts.ownTriangles },
      { "held_triangles", rank.counts.heldTriangles }, { "bytes_sent", rank.counts.bytesSent },
      { "exchanges", rank.counts.exchanges }, { "peak_memory_mib", rank.peakMemoryMiB } });
  }
  return list;
}

double peakMemoryOf(const std::vector<RankFigures>& ranks)
{
  double peak = peakMemoryMiB();
  for (const RankFigures& rank : ranks)
  {
    peak = std::max(peak, rank.peakMemoryMiB);
  }
  return peak;
}

Json describeCoverage(const Result& result, const Options& options)
{
  const std::optional<AxisCoverage>& coverage = result.coverage;
  if (!coverage)
  {
    return nullptr;
  }
  Json places = Json::array();
  for (const UncoveredPlace& place : coverage->places)
  {
    places.push_back({ { "point", place.point }, { "share", place.share } });
  }
  const std::optional<double> spacing = catchingSpacing(result, options);
  return { { "places", places }, { "spacing", spacing ? Json(*spacing) : Json(nullptr) },
    { "uncovered_share", coverage->uncoveredShare }, { "reach", coverage->reach },
    { "samples", coverage->samples }, { "seconds", coverage->seconds } };
}

} // namespace

double peakMemoryMiB()
{
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::string makeReport(const Result& result, const Options& options, const AppSeconds& seconds)
{
  // Thickness alone needs no grid, and so no sign and no engine.
  const bool field = options.wantsGrid();
  const auto ofField = [field](Json value) { return field ? std::move(value) : Json(nullptr); };
  const auto ofAxis = [&options](Json value)
  { return options.wantsAxis() ? std::move(value) : Json(nullptr); };
  Json report;
  report["version"] = MEDIAL_VERSION;
  report["parameters"] = describeParameters(result, options);
  report["input"] = describeInput(result, options.input);
  report["grid"] = ofField(describeGrid(result.grid));
  report["device"] = describeDevice(result.statistics.device);
  report["seconds"] = describeSeconds(result.statistics.seconds, seconds);
  report["device_seconds"] = describeSeconds(result.statistics.deviceSeconds);
  report["bytes_uploaded"] = result.statistics.bytesUploaded;
  report["bytes_read_back"] = result.statistics.bytesReadBack;
  report["dispatches"] = result.statistics.dispatches;
  report["counts"] = describeCounts(result);
  report["simplification"] = describeSimplification(result.axis.simplification);
  report["fragments_per_voxel"] = result.statistics.fragmentsPerVoxel();
  report["engine"] = ofField(nameOf(result.statistics.engine));
  report["sign_method"] = ofField(nameOf(result.sign));
  report["sign"] = ofField(describeSign(result.statistics.sign));
  report["side"] = ofAxis(nameOf(result.axis.side));
  if (result.thickness)
  {
    report["thickness"] = describeThickness(result, options);
  }
  if (result.skeleton)
  {
    report["skeleton"] = describeSkeleton(*result.skeleton);
  }
  if (result.localThickness)
  {
    report["local_thickness"] = describeLocalThickness(*result.localThickness);
  }
  report["topology"] = ofAxis(describeTopology(result, options.topology));
  report["coverage"] = describeCoverage(result, options);
  report["peak_memory_mib"] = peakMemoryOf(result.ranks);
  report["ranks"] = describeRanks(result.ranks);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeReport(const std::string& report, const std::filesystem::path& file)
{
  writeFile(file, report);
}

} // namespace medial::app

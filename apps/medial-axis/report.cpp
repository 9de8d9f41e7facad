#include "report.h"

#include "sink.h"
#include "text_cursor.h"

#include <vtkMedialAxis.h>
#include <vtkPolyData.h>

#include <nlohmann/json.hpp>

#include <array>

#include <sys/resource.h>

namespace medial::app
{
namespace
{

using Json = nlohmann::ordered_json;

Json describeInput(vtkMedialAxis* filter, const std::filesystem::path& input)
{
  return { { "path", input.string() }, { "triangles", filter->GetNumberOfTriangles() },
    { "vertices", filter->GetNumberOfVertices() }, { "closed", filter->GetClosed() },
    { "manifold", filter->GetManifold() }, { "components", filter->GetNumberOfComponents() },
    { "skipped_degenerate", filter->GetNumberOfDegenerateTriangles() } };
}

Json describeGrid(vtkMedialAxis* filter)
{
  std::array<int, 3> dimensions{};
  std::array<double, 3> spacing{};
  std::array<double, 3> origin{};
  filter->GetUsedDimensions(dimensions.data());
  filter->GetUsedSpacing(spacing.data());
  filter->GetUsedOrigin(origin.data());
  return { { "dimensions", dimensions }, { "spacing", spacing }, { "origin", origin } };
}

Json describeDevice(vtkMedialAxis* filter)
{
  return { { "renderer", filter->GetRenderer() }, { "version", filter->GetRendererVersion() },
    { "software", filter->GetSoftwareRenderer() } };
}

Json describeSeconds(vtkMedialAxis* filter, const AppSeconds& seconds)
{
  return { { "read", seconds.read }, { "sites", filter->GetSitesSeconds() },
    { "cull", filter->GetCullSeconds() }, { "polygons", filter->GetPolygonsSeconds() },
    { "draw", filter->GetDrawSeconds() }, { "resolve", filter->GetResolveSeconds() },
    { "medial", filter->GetMedialSeconds() }, { "write", seconds.write },
    { "total", seconds.total } };
}

Json describeCounts(vtkMedialAxis* filter)
{
  return { { "sites", filter->GetNumberOfSites() }, { "polygons", filter->GetNumberOfPolygons() },
    { "fragments", filter->GetNumberOfFragments() },
    { "candidate_pairs", filter->GetNumberOfCandidatePairs() },
    { "medial_points", filter->GetOutput()->GetNumberOfPoints() },
    { "medial_cells", filter->GetOutput()->GetNumberOfCells() } };
}

double fragmentsPerVoxel(vtkMedialAxis* filter)
{
  const auto samples = static_cast<double>(filter->GetNumberOfSamples());
  return samples > 0.0 ? static_cast<double>(filter->GetNumberOfFragments()) / samples : 0.0;
}

double peakMemoryMiB()
{
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

} // namespace

std::string makeReport(vtkMedialAxis* filter, const std::filesystem::path& input,
  const AppSeconds& seconds)
{
  Json report;
  report["input"] = describeInput(filter, input);
  report["grid"] = describeGrid(filter);
  report["device"] = describeDevice(filter);
  report["seconds"] = describeSeconds(filter, seconds);
  report["counts"] = describeCounts(filter);
  report["fragments_per_voxel"] = fragmentsPerVoxel(filter);
  report["evaluator"] = lowerCase(filter->GetUsedEvaluatorAsString());
  report["sign_method"] = lowerCase(filter->GetUsedSignMethodAsString());
  report["peak_memory_mib"] = peakMemoryMiB();
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeReport(const std::string& report, const std::filesystem::path& file)
{
  Sink sink(file);
  sink << report.c_str();
  sink.close();
}

} // namespace medial::app

#include "summary.h"

#include "option_names.h"

#include <vtkPolyData.h>

#include <cstdio>
#include <string>

namespace medial::app
{
namespace
{

/// Share of the surface without axis from which on the user is told.
constexpr double kNoticeableShare = 0.01;

void printMesh(const Options& options, const Result& result)
{
  const auto components = static_cast<long long>(result.topology.components);
  std::printf("mesh      %s: %zu triangles, %zu vertices, %lld component%s, %s\n",
    options.input.c_str(), result.mesh.triangles.size(), result.mesh.points.size(), components,
    components == 1 ? "" : "s", result.topology.closed() ? "closed" : "not closed");
}

void printGrid(const Result& result)
{
  const Grid& grid = result.grid;
  std::printf("grid      %d x %d x %d points, spacing %.4g, sign: %s\n", grid.dimensions[0],
    grid.dimensions[1], grid.dimensions[2], grid.spacing[0], nameOf(result.sign).c_str());
}

void printThickness(const Options& options, const Thickness& thickness)
{
  std::printf("thickness %s: min %.4g, median %.4g, max %.4g, none at %.3g %% of the points, "
              "in %.2f s\n",
    nameOf(options.side).c_str(), thickness.least, thickness.median, thickness.greatest,
    100.0 * thickness.shareWithout(), thickness.seconds);
}

void printSeconds(const RunStatistics::Seconds& run, const AppSeconds& app)
{
  std::printf("seconds   read %.2f, sites %.2f, cull %.2f, polygons %.2f, draw %.2f, resolve %.2f, "
              "medial %.2f, write %.2f, total %.2f\n",
    app.read, run.sites, run.cull, run.polygons, run.draw, run.resolve, run.medial, app.write,
    app.total);
}

void printFile(const std::filesystem::path& path, const std::string& content)
{
  if (!path.empty())
  {
    std::printf("wrote     %s: %s\n", path.c_str(), content.c_str());
  }
}

void printOutputs(const Options& options, const Result& result)
{
  vtkPolyData* axis = result.axis;
  printFile(options.output,
    "medial axis, " + std::to_string(axis->GetNumberOfPoints()) + " points, " +
      std::to_string(axis->GetNumberOfCells()) + " cells");
  if (result.curves)
  {
    printFile(options.curves,
      "curves of the axis, " + std::to_string(result.curves->GetNumberOfLines()) + " polylines");
  }
  printFile(options.field, "distance field");
  printFile(options.thickness, "surface with thickness");
  printFile(options.thicknessImage, "picture of thickness");
  printFile(options.image, "picture of axis and surface");
  printFile(options.html, "page with axis and surface");
  printFile(options.report, "report of the run");
}

const char* whyUnsigned(const Options& options, const Result& result)
{
  if (options.signMethod == SignMethod::None)
  {
    return "sign method none";
  }
  return result.topology.closed() ? "the mesh is not consistently oriented"
                                  : "the mesh is not closed";
}

void printNotes(const Options& options, const Result& result)
{
  if (result.side != options.side)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: the distance is unsigned (%s), so the axis is that of both sides\n",
      options.input.c_str(), whyUnsigned(options, result));
  }
  if (result.axis->GetNumberOfPoints() == 0)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: no point of the grid has a separation angle of %g degrees or more\n",
      options.input.c_str(), options.angle);
  }
}

void printPageNotes(const Options& options, const Result& result)
{
  for (const std::string& note : result.pageNotes)
  {
    std::fprintf(stderr, "medial-axis: note: %s: to keep the page small %s\n", options.html.c_str(),
      note.c_str());
  }
}

void printSimplification(const Options& options, const Result& result)
{
  const SimplificationStatistics& done = result.simplification;
  const auto components = static_cast<long long>(done.components);
  if (done.dropped > 0)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: --max-spheres %d is below the number of components of the axis, "
      "%lld; "
      "the %lld smallest were left out\n",
      options.input.c_str(), options.maxSpheres, components + static_cast<long long>(done.dropped),
      static_cast<long long>(done.dropped));
  }
  else if (done.forced > 0)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: --max-spheres %d closes holes of the shape: fewer balls than its "
      "topology needs\n",
      options.input.c_str(), options.maxSpheres);
  }
  if (done.inputPoints > 0)
  {
    std::printf("simplified %lld points in %lld component%s to %lld in %lld, %.2f s\n",
      static_cast<long long>(done.inputPoints), static_cast<long long>(done.inputComponents),
      done.inputComponents == 1 ? "" : "s",
      static_cast<long long>(result.axis->GetNumberOfPoints()), components, done.seconds);
  }
}

void printCoverage(const Options& options, const AxisCoverage& coverage)
{
  if (coverage.uncoveredShare >= kNoticeableShare)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: %.3g %% of the surface is farther than a voxel's diagonal, %.4g, "
      "from what the axis describes: the grid, the selection or --max-spheres leaves parts out\n",
      options.input.c_str(), 100.0 * coverage.uncoveredShare, coverage.reach);
  }
}

} // namespace

void printSummary(const Options& options, const Result& result, const AppSeconds& seconds)
{
  if (options.wantsAxis())
  {
    printNotes(options, result);
  }
  if (result.coverage)
  {
    printCoverage(options, *result.coverage);
  }
  printPageNotes(options, result);
  printMesh(options, result);
  if (options.wantsAxis() || !options.field.empty())
  {
    printGrid(result);
    const Device& device = result.statistics.device;
    std::printf("renderer  %s%s\n", device.renderer.c_str(), device.software ? " (software)" : "");
  }
  if (result.thickness)
  {
    printThickness(options, *result.thickness);
  }
  printSeconds(result.statistics.seconds, seconds);
  printSimplification(options, result);
  printOutputs(options, result);
}

} // namespace medial::app

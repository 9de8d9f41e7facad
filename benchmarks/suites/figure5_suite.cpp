#include "suites/suite.h"

#include <algorithm>
#include <cmath>

namespace medial::benchmark
{
namespace
{

/// Fits leave out the coarsest grids, whose time is that of the triangles.
constexpr int kFitFrom = 64;
/// Resolution from which on the slow methods are left out.
constexpr int kBaselinesUpTo = 128;

int longestAxis(const Grid& grid)
{
  return *std::max_element(grid.dimensions.begin(), grid.dimensions.end());
}

std::vector<int> resolutions(const SuiteContext& context)
{
  std::vector<int> result;
  for (int resolution = 32; resolution <= 512; resolution *= 2)
  {
    if (context.options().resolution == 0 || resolution <= context.options().resolution)
    {
      result.push_back(resolution);
    }
  }
  return result.empty()
    ? std::vector<int>{ context.options().resolution / 2, context.options().resolution }
    : result;
}

/// Time grows with this power of the number of grid points.
double exponentAgainstVoxels(const std::vector<Row>& rows, const std::string& id)
{
  std::vector<Row> fine;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(fine),
    [](const Row& row) { return longestAxis(row.grid) >= kFitFrom; });
  return exponentOf(secondsCurve(fine, id, id,
    [](const Row& row) { return static_cast<double>(row.grid.pointCount()); }));
}

CurvePlot plotOf(const std::vector<Row>& rows, const std::vector<std::string>& methods)
{
  CurvePlot plot;
  plot.name = "figure5-" + rows.front().mesh;
  plot.title = "Time against resolution: " + rows.front().mesh;
  plot.xLabel = "grid points along the longest axis";
  plot.yLabel = "median time (s), bars from least to greatest";
  for (const Row& row : rows)
  {
    plot.ticks.push_back(longestAxis(row.grid));
  }
  for (const std::string& id : methods)
  {
    if (const MethodRun* run = rows.front().find(id))
    {
      const double exponent = exponentAgainstVoxels(rows, id);
      const std::string name =
        std::isfinite(exponent) ? run->name + ", voxels^" + number(exponent, 2) : run->name;
      plot.curves.push_back(
        secondsCurve(rows, id, name, [](const Row& row) { return longestAxis(row.grid); }));
    }
  }
  return plot;
}

} // namespace

SuiteReport runFigure5(const SuiteContext& context)
{
  const std::vector<std::string> methods = { kMedialId, "embree", "published", "havoc" };
  SuiteReport report;
  report.name = "figure5";
  report.title = "Time against resolution";
  report.rounds = context.options().repeats;
  report.notes = { "Fits are of time against the number of grid points, for " +
    std::to_string(kFitFrom) + " and more points along the longest axis." };
  SuiteContext::noteAbsent(methods, report);
  Table fits;
  fits.title = "Time grows with the number of grid points to this power:";
  fits.columns = { "mesh", "Medial", "Embree" };
  for (const MeshRequest& mesh : { triceratops(), gargoyle(), bunny() })
  {
    std::vector<Row> rows;
    for (const int resolution : resolutions(context))
    {
      const std::vector<std::string> allowed =
        resolution <= kBaselinesUpTo ? methods : std::vector<std::string>{ kMedialId, "embree" };
      if (auto row = context.measure(mesh, gridOfResolution(resolution), allowed))
      {
        rows.push_back(std::move(*row));
      }
    }
    if (rows.empty())
    {
      continue;
    }
    const double ours = exponentAgainstVoxels(rows, kMedialId);
    const double embree = exponentAgainstVoxels(rows, "embree");
    report.figures[mesh.name] = { { "exponent_medial", ours }, { "exponent_embree", embree } };
    fits.rows.push_back({ mesh.name, number(ours), number(embree) });
    report.curves.push_back(plotOf(rows, methods));
    std::move(rows.begin(), rows.end(), std::back_inserter(report.rows));
  }
  report.tables = { fits, methodTable(report.rows), phaseTable(report.rows) };
  report.tables[1].title = "All samples:";
  return report;
}

} // namespace medial::benchmark

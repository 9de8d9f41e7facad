#include "suites/suite.h"

#include <algorithm>
#include <cmath>

namespace medial::benchmark
{
namespace
{

/// Fits leave out the coarsest grids, whose time is that of the triangles.
constexpr int kFitFrom = 64;
constexpr int kFinest = 512;
/// Maximum exponent that Medial should have.
constexpr double kTargetExponent = 1.05;

std::vector<int> resolutions(const SuiteContext& context)
{
  std::vector<int> result;
  for (int resolution = 32; resolution <= kFinest; resolution *= 2)
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

/// A method that was too slow, or failed, at one resolution would do so at the next.
void leaveOutSlow(const Row& row, std::vector<std::string>& methods)
{
  const auto slow = [&](const std::string& id)
  {
    const MethodRun* run = row.find(id);
    return run && run->samples.empty();
  };
  methods.erase(std::remove_if(methods.begin(), methods.end(), slow), methods.end());
}

/// Plots, fits, targets and tables of the rows measured so far.
void describe(const SuiteContext& context, const std::vector<std::string>& methods,
  SuiteReport& report)
{
  const std::vector<std::string> fitted = { kMedialId, kRasterId, "embree" };
  Table fits;
  fits.title = "Time grows with the number of grid points to this power:";
  fits.columns = { "mesh", "Medial", "Medial, rasteriser", "Embree" };
  report.curves.clear();
  report.targets.clear();
  for (const std::vector<Row>& rows :
    groupRows(report.rows, [](const Row& row) { return row.mesh; }))
  {
    const std::string& mesh = rows.front().mesh;
    fits.rows.push_back({ mesh });
    for (const std::string& id : fitted)
    {
      const double exponent = exponentAgainstVoxels(rows, id);
      report.figures[mesh]["exponent_" + id] = exponent;
      fits.rows.back().push_back(number(exponent));
    }
    const bool whole = longestAxis(rows.back().grid) == kFinest;
    report.targets.push_back(
      { mesh, "Medial's exponent, grids of 64 to 512", Target::Kind::AtMost, kTargetExponent,
        exponentAgainstVoxels(rows, kMedialId), whole && context.targetsApply(rows.front()) });
    report.curves.push_back(plotOf(rows, methods));
  }
  report.tables = { fits, methodTable(report.rows), phaseTable(report.rows) };
  report.tables[1].title = "All samples:";
}

} // namespace

void runFigure5(const SuiteContext& context)
{
  const std::vector<std::string> methods = { kMedialId, kRasterId, "embree", "published", "havoc" };
  SuiteReport report;
  report.name = "figure5";
  report.title = "Time against resolution";
  report.rounds = context.options().repeats;
  report.notes = { "Fits are of time against the number of grid points, for " +
      std::to_string(kFitFrom) + " and more points along the longest axis.",
    "A method that would take more than " + number(context.options().timeCap) +
      " s on one grid is left out of the finer ones." };
  SuiteContext::noteAbsent(methods, report);
  for (const MeshRequest& mesh : { triceratops(), gargoyle(), bunny() })
  {
    std::vector<std::string> allowed = methods;
    for (const int resolution : resolutions(context))
    {
      if (auto row = context.measure(mesh, gridOfResolution(resolution), allowed))
      {
        leaveOutSlow(*row, allowed);
        report.rows.push_back(std::move(*row));
        describe(context, methods, report);
        context.publish(report);
      }
    }
  }
}

} // namespace medial::benchmark

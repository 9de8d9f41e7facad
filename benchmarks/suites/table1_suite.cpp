#include "suites/suite.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial::benchmark
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A line of the paper's table 1.
struct Case
{
  MeshRequest mesh;
  std::array<int, 3> dimensions; ///< zero: 256 points along the longest axis
  double paperSeconds;           ///< on a GeForce 7800, as published
  std::string difference;        ///< of the mesh from the paper's
};

std::vector<Case> cases()
{
  return { { triceratops(), { 256, 112, 84 }, 0.768, "the same model, another file" },
    { head(), { 78, 105, 128 }, 0.846, "Igea, decimated to the paper's 22K triangles" },
    { gargoyle(), {}, 0.625, "decimated; grid as our padding makes it" },
    { bunny(), { 256, 252, 196 }, 0.772, "decimated to 1.5K triangles" },
    { shellCharge(), { 126, 128, 126 }, 0.276,
      "substitute: a cube minus a sphere, 4.1K triangles" } };
}

/// Isotropic grid of the given dimensions, centred on the mesh, as fine as lets the bounds fit in
/// with the default padding.
Grid fittedGrid(const TriangleMesh& mesh, const std::array<int, 3>& dimensions)
{
  const Bounds bounds = mesh.bounds();
  const double margin = kDefaultPadding * bounds.diagonal();
  double spacing = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds.max[axis] - bounds.min[axis] + 2.0 * margin;
    spacing = std::max(spacing, length / (dimensions[axis] - 1));
  }
  Grid grid;
  grid.spacing = { spacing, spacing, spacing };
  grid.dimensions = dimensions;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double centre = 0.5 * (bounds.min[axis] + bounds.max[axis]);
    grid.origin[axis] = centre - 0.5 * spacing * (dimensions[axis] - 1);
  }
  return grid;
}

/// The case's grid, scaled to another longest axis where the options ask for one.
SuiteContext::MakeGrid gridOf(const Case& one, const SuiteContext& context)
{
  if (one.dimensions[0] == 0)
  {
    return gridOfResolution(context.resolution(kDefaultResolution));
  }
  const int longest = *std::max_element(one.dimensions.begin(), one.dimensions.end());
  const double scale = static_cast<double>(context.resolution(longest)) / longest;
  std::array<int, 3> dimensions{};
  for (int axis = 0; axis < 3; ++axis)
  {
    dimensions[axis] = std::max(2, static_cast<int>(std::lround(scale * one.dimensions[axis])));
  }
  return [dimensions](const TriangleMesh& mesh) { return fittedGrid(mesh, dimensions); };
}

std::vector<std::string> paperCells(const Case& one, const Row& row)
{
  const MethodRun* ours = row.find(kMedialId);
  return { row.mesh, row.note.empty() ? one.difference : row.note, thousands(row.triangles),
    dimensionsText(row.grid), number(one.paperSeconds), secondsText(row, kMedialId),
    ours ? number(one.paperSeconds / ours->medianSeconds(), 2) : "-", secondsText(row, kRasterId),
    secondsText(row, "published"), secondsText(row, "havoc"), secondsText(row, "embree") };
}

Target targetOf(const Case& one, const Row& row, const SuiteContext& context)
{
  const MethodRun* ours = row.find(kMedialId);
  return { row.mesh, "Medial's seconds, against the paper's", Target::Kind::AtMost,
    one.paperSeconds, ours ? ours->medianSeconds() : kNaN, context.targetsApply(row) };
}

BarPlot plotOf(const std::vector<Row>& rows, const std::vector<double>& paperSeconds)
{
  BarPlot plot;
  plot.name = "table1";
  plot.title = "The paper's meshes and grids";
  plot.yLabel = "median time (s)";
  for (const MethodRun& run : rows.front().runs)
  {
    plot.bars.push_back(run.name);
  }
  plot.bars.emplace_back("paper, 2006, GeForce 7800");
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    plot.groups.push_back(rows[i].mesh);
    std::vector<double> heights;
    for (const MethodRun& run : rows[i].runs)
    {
      heights.push_back(run.samples.empty() ? kNaN : run.medianSeconds());
    }
    heights.push_back(paperSeconds[i]);
    plot.heights.push_back(heights);
  }
  return plot;
}

} // namespace

void runTable1(const SuiteContext& context)
{
  const std::vector<std::string> methods = { kMedialId, kRasterId, "published", "havoc", "embree" };
  SuiteReport report;
  report.name = "table1";
  report.title = "The paper's table 1";
  report.rounds = context.options().repeats;
  report.notes = {
    "\"Paper\" are the seconds that Sud, Govindaraju, Gayle and Manocha published in "
    "2006 for a GeForce 7800: figures of theirs, not run here, on other hardware "
    "and, as the second column says, on meshes that are not quite the same.",
    "Grids have the paper's dimensions and are isotropic, as fine as lets the mesh fit in with 5 % "
    "of its diagonal around it."
  };
  SuiteContext::noteAbsent(methods, report);
  Table table;
  table.columns = { "mesh", "mesh used here", "triangles", "grid", "paper (s)", "Medial (s)",
    "paper / Medial", "Medial, rasteriser (s)", "as published (s)", "HAVOC (s)", "Embree (s)" };
  std::vector<double> paperSeconds;
  for (const Case& one : cases())
  {
    if (auto row = context.measure(one.mesh, gridOf(one, context), methods))
    {
      table.rows.push_back(paperCells(one, *row));
      paperSeconds.push_back(one.paperSeconds);
      report.targets.push_back(targetOf(one, *row, context));
      report.rows.push_back(std::move(*row));
      Table details = methodTable(report.rows);
      details.title = "Ratios and errors:";
      report.tables = { table, details, phaseTable(report.rows) };
      report.bars = { plotOf(report.rows, paperSeconds) };
      context.publish(report);
    }
  }
}

} // namespace medial::benchmark

#include "suites/suite.h"

#include <iostream>
#include <limits>

namespace medial::benchmark
{
namespace
{

/// The torus whose bounds all grids are made for: finer ones are hardly larger.
constexpr int kBoundingTriangles = 200000;

std::vector<std::string> methods()
{
  return { kMedialId, "embree" };
}

std::vector<int> sizes(const Options& options)
{
  if (options.quick)
  {
    return { 1000, 2000, 4000 };
  }
  std::vector<int> result;
  for (const int triangles : { 10000, 20000, 50000, 100000, 200000, 500000, 1000000, 2000000 })
  {
    if (triangles <= options.maxTriangles)
    {
      result.push_back(triangles);
    }
  }
  return result;
}

std::vector<int> resolutions(const Options& options)
{
  if (options.quick)
  {
    return { options.resolution / 2, options.resolution };
  }
  return options.resolution > 0 ? std::vector<int>{ options.resolution }
                                : std::vector<int>{ 128, 256 };
}

std::string nameOf(int triangles)
{
  return "torus " +
    (triangles < 1000000 ? std::to_string(triangles / 1000) + "K"
                         : std::to_string(triangles / 1000000) + "M");
}

double trianglesOf(const Row& row)
{
  return static_cast<double>(row.triangles);
}

std::string gridText(const Row& row)
{
  return dimensionsText(row.grid);
}

/// Time grows with this power of the number of triangles; NaN for a method that sat out a mesh,
/// since exponents of different meshes cannot be compared.
double exponentAgainstTriangles(const std::vector<Row>& rows, const std::string& id)
{
  const CurvePlot::Curve curve = secondsCurve(rows, id, id, trianglesOf);
  return curve.points.size() == rows.size() ? exponentOf(curve)
                                            : std::numeric_limits<double>::quiet_NaN();
}

CurvePlot plotOf(const std::vector<Row>& rows)
{
  const std::string resolution = std::to_string(longestAxis(rows.front().grid));
  CurvePlot plot;
  plot.name = "triangles-" + resolution;
  plot.title = "Time against triangles, " + resolution + " grid points along the longest axis";
  plot.xLabel = "triangles";
  plot.yLabel = "median time (s), bars from least to greatest";
  for (const MethodRun& run : rows.front().runs)
  {
    const std::string power = number(exponentAgainstTriangles(rows, run.id), 2);
    plot.curves.push_back(
      secondsCurve(rows, run.id, run.name + ", triangles^" + power, trianglesOf));
  }
  return plot;
}

/// Plots, fits and tables of the rows measured so far.
void describe(SuiteReport& report)
{
  Table fits;
  fits.title = "Time grows with the number of triangles to this power (least squares of logarithms "
               "of medians):";
  fits.columns = { "grid", "triangles", "Medial", "Embree" };
  report.curves.clear();
  for (const std::vector<Row>& rows : groupRows(report.rows, gridText))
  {
    const std::string grid = gridText(rows.front());
    fits.rows.push_back(
      { grid, thousands(rows.front().triangles) + " to " + thousands(rows.back().triangles) });
    for (const std::string& id : methods())
    {
      const double exponent = exponentAgainstTriangles(rows, id);
      report.figures[grid]["exponent_" + id] = exponent;
      fits.rows.back().push_back(number(exponent));
    }
    report.curves.push_back(plotOf(rows));
  }
  report.tables = { fits, methodTable(report.rows), phaseTable(report.rows) };
  report.tables[1].title = "All samples:";
}

} // namespace

void runTriangles(const SuiteContext& context)
{
  const Bounds bounds = bumpyTorus(kBoundingTriangles).bounds();
  SuiteReport report;
  report.name = "triangles";
  report.title = "Time against the number of triangles";
  report.rounds = context.options().repeats;
  report.notes = { "A bumpy torus, meshed more and more finely, on the same grids." };
  SuiteContext::noteAbsent(methods(), report);
  for (const int resolution : resolutions(context.options()))
  {
    const Grid grid = makeGrid(bounds, resolution);
    const auto sameGrid = [&](const TriangleMesh&) { return grid; };
    for (const int triangles : sizes(context.options()))
    {
      const MeshRequest mesh{ nameOf(triangles), "", triangles };
      if (auto row = context.measure(mesh, sameGrid, methods(), context.allRounds()))
      {
        report.rows.push_back(std::move(*row));
        describe(report);
        context.publish(report);
      }
    }
  }
  if (!report.tables.empty())
  {
    std::cerr << report.tables.front().markdown();
  }
}

} // namespace medial::benchmark

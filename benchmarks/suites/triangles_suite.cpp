#include "suites/suite.h"

namespace medial::benchmark
{
namespace
{

double trianglesOf(const Row& row)
{
  return static_cast<double>(row.triangles);
}

/// Fits use the dense half, where the triangles and no longer the grid points decide the time.
constexpr double kFitFrom = 10000.0;
constexpr int kMaxTriangles = 200000;

/// Plot, fits and tables of the rows measured so far.
void describe(const std::vector<std::string>& methods, int resolution, SuiteReport& report)
{
  CurvePlot plot;
  plot.name = "triangles";
  plot.title =
    "Time against triangles, " + std::to_string(resolution) + " grid points along the longest axis";
  plot.xLabel = "triangles";
  plot.yLabel = "median time (s), bars from least to greatest";
  Table fits;
  fits.title = "Time grows with the number of triangles, from 10K on, to this power:";
  fits.columns = { "method", "exponent" };
  for (const std::string& id : methods)
  {
    if (const MethodRun* run = report.rows.front().find(id))
    {
      plot.curves.push_back(secondsCurve(report.rows, id, run->name, trianglesOf));
      const double exponent = exponentOf(plot.curves.back(), kFitFrom);
      report.figures["exponent_" + id] = exponent;
      fits.rows.push_back({ run->name, number(exponent) });
    }
  }
  report.curves = { plot };
  report.tables = { fits, methodTable(report.rows), phaseTable(report.rows) };
  report.tables[1].title = "All samples:";
}

} // namespace

void runTriangles(const SuiteContext& context)
{
  const std::vector<std::string> methods = { kMedialId, kRasterId, "embree" };
  const int resolution = context.resolution(128);
  const Grid grid = makeGrid(bumpyTorus(kMaxTriangles).bounds(), resolution);
  const auto sameGrid = [&](const TriangleMesh&) { return grid; };
  SuiteReport report;
  report.name = "triangles";
  report.title = "Time against the number of triangles";
  report.rounds = context.options().repeats;
  report.notes = { "A bumpy torus, meshed more and more finely, on one grid." };
  SuiteContext::noteAbsent(methods, report);
  for (const int triangles : { 1000, 2000, 5000, 10000, 20000, 50000, 100000, kMaxTriangles })
  {
    if (context.options().quick && triangles > 2000)
    {
      break;
    }
    const MeshRequest mesh{ "torus " + std::to_string(triangles / 1000) + "K", "", triangles };
    if (auto row = context.measure(mesh, sameGrid, methods))
    {
      report.rows.push_back(std::move(*row));
      describe(methods, resolution, report);
      context.publish(report);
    }
  }
}

} // namespace medial::benchmark

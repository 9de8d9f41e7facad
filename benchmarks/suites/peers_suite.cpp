#include "suites/suite.h"

#include <limits>

namespace medial::benchmark
{
namespace
{

struct Case
{
  MeshRequest mesh;
  int resolution;
};

BarPlot secondsPlot(const std::vector<Row>& rows)
{
  BarPlot plot;
  plot.name = "peers";
  plot.title = "Whole distance fields";
  plot.yLabel = "median time (s)";
  for (const Row& row : rows)
  {
    plot.groups.push_back(row.mesh);
    std::vector<double> heights;
    for (const MethodRun& run : row.runs)
    {
      heights.push_back(run.medianSeconds());
    }
    plot.heights.push_back(heights);
  }
  for (const MethodRun& run : rows.front().runs)
  {
    plot.bars.push_back(run.name);
  }
  return plot;
}

} // namespace

SuiteReport runPeers(const SuiteContext& context)
{
  const std::vector<std::string> methods = { kMedialId, "embree", "cgal", "openvdb", "openvdb-band",
    "vtk" };
  const std::vector<Case> cases = { { triceratops(), 256 }, { bunny(), 256 }, { gargoyle(), 256 },
    { head(), 128 }, { { "armadillo", "organic/armadillo_52k.off", 52000 }, 256 },
    { { "dragon", "large/dragon_100k_closed.obj", 100000 }, 256 } };
  SuiteReport report;
  report.name = "peers";
  report.title = "Distance fields: Medial and its peers";
  report.rounds = context.options().repeats;
  report.notes = { "Trees are asked for every grid point, along a Morton curve of blocks, with the "
                   "neighbour's answer as first guess; results are triangles and distances.",
    "OpenVDB's whole-grid band is as narrow as the grid allows, but it reaches as far outside of "
    "the grid; the band of 3 voxels answers only near the surface.",
    "VTK's vtkImplicitPolyDataDistance is timed on a share of the grid's rows and scaled; it tells "
    "no triangle." };
  SuiteContext::noteAbsent(methods, report);
  for (const Case& one : cases)
  {
    const int resolution = context.resolution(one.resolution);
    if (auto row = context.measure(one.mesh, gridOfResolution(resolution), methods))
    {
      report.rows.push_back(std::move(*row));
    }
  }
  report.tables = { methodTable(report.rows), phaseTable(report.rows) };
  if (!report.rows.empty() && !report.rows.front().runs.empty())
  {
    report.bars.push_back(secondsPlot(report.rows));
  }
  return report;
}

} // namespace medial::benchmark

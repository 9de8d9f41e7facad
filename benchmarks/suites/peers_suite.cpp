#include "suites/suite.h"

#include "statistics.h"

namespace medial::benchmark
{
namespace
{

/// Targets that are the same for all meshes.
constexpr double kMaxGeometryShare = 35.0; ///< percent
constexpr double kMaxError = 1e-2;         ///< voxels
constexpr double kUsualError = 1e-3;       ///< voxels, at 99.99 % of the grid points
constexpr double kOutputsOfPeak = 3.0;     ///< peak of memory, in output arrays ...
constexpr double kFixedPeak = 150e6;       ///< ... and bytes on top of them

struct Case
{
  MeshRequest mesh;
  int resolution;
  double speedUp; ///< target: Embree's seconds over ours
};

std::vector<Case> cases()
{
  return { { triceratops(), 256, 7.0 }, { bunny(), 256, 20.0 }, { gargoyle(), 256, 10.0 },
    { head(), 128, 5.0 }, { armadillo(), 256, 6.0 }, { dragon(), 256, 4.0 } };
}

std::vector<Target> targetsOf(const Case& one, const Row& row, bool apply)
{
  using Kind = Target::Kind;
  std::vector<Target> targets;
  const auto add = [&](const std::string& what, Kind kind, double bound, double measured) {
    targets.push_back({ row.mesh, what, kind, bound, measured, apply });
  };
  if (const MethodRun* embree = row.find("embree"))
  {
    add("Embree's seconds over Medial's", Kind::AtLeast, one.speedUp, median(embree->ratios));
  }
  if (const MethodRun* ours = row.find(kMedialId); ours && ours->accuracy)
  {
    add("sites, cull and polygons, % of Medial's seconds", Kind::AtMost, kMaxGeometryShare,
      100.0 * geometryShare(*ours));
    add("greatest error, voxels", Kind::AtMost, kMaxError, ours->accuracy->most());
    add("error of 99.99 % of grid points, voxels", Kind::AtMost, kUsualError,
      ours->accuracy->quantile9999());
    if (ours->peakBytes)
    {
      add("peak of memory, MB", Kind::AtMost,
        (kOutputsOfPeak * row.outputBytes() + kFixedPeak) / 1e6, *ours->peakBytes / 1e6);
    }
  }
  return targets;
}

} // namespace

void runPeers(const SuiteContext& context)
{
  const std::vector<std::string> methods = { kMedialId, kRasterId, "embree", "cgal", "openvdb",
    "openvdb-band", "vtk" };
  MeasurementOptions measurement = context.measurement();
  measurement.memoryOf = { kMedialId, kRasterId, "embree" };
  SuiteReport report;
  report.name = "peers";
  report.title = "Distance fields: Medial and its peers";
  report.rounds = measurement.repeats;
  report.notes = { "Trees are asked for every grid point, along a Morton curve of blocks, with the "
                   "neighbour's answer as first guess; results are triangles and distances.",
    "OpenVDB's whole-grid band is as narrow as the grid allows, but it reaches as far outside of "
    "the grid; the band of 3 voxels answers only near the surface.",
    "VTK's vtkImplicitPolyDataDistance is timed on a share of the grid's rows and scaled; it tells "
    "no triangle.",
    "Peak MB is the growth of a new process's resident memory during its first call, OpenGL's "
    "start and the output arrays included; these are 8 bytes a grid point. The target for it is 3 "
    "times the output arrays and 150 MB." };
  SuiteContext::noteAbsent(methods, report);
  for (const Case& one : cases())
  {
    const int resolution = context.resolution(one.resolution);
    if (auto row = context.measure(one.mesh, gridOfResolution(resolution), methods, measurement))
    {
      for (const Target& target : targetsOf(one, *row, context.targetsApply(*row)))
      {
        report.targets.push_back(target);
      }
      report.rows.push_back(std::move(*row));
      report.tables = { methodTable(report.rows), phaseTable(report.rows) };
      if (!report.rows.front().runs.empty())
      {
        report.bars = { secondsBars(report.rows, report.name, "Whole distance fields") };
      }
      context.publish(report);
    }
  }
}

} // namespace medial::benchmark

#include "suites/suite.h"

#include "base/stopwatch.h"
#include "skeletons/skeleton_method.h"
#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>

namespace medial::benchmark
{
namespace
{

constexpr int kQuickTriangles = 600;
constexpr const char* kCgalId = "cgal";

std::vector<SkeletonMethodEntry> availableMethods(int resolution)
{
  return { { "medial", [resolution] { return makeMedialSkeleton(resolution); } },
    { "medial-auto", [] { return makeMedialSkeleton(std::nullopt); } },
#ifdef MEDIAL_HAVE_CGAL_SKELETON
    { kCgalId, makeCgalSkeleton }
#endif
  };
}

std::vector<MeshRequest> meshes()
{
  return { { "knots", "multi/knot2_2comp_11.5k.off", 11520 }, gargoyle(),
    { "aorta", "vessel/aorta_closed_12.9k.stl", 12932 },
    { "hand", "organic/hand_24.9k.obj", 24916 }, { "horse", "organic/horse_40k.off", 39698 },
    armadillo(), dragon() };
}

Phases figuresOf(const Network& network)
{
  Phases figures{ { "branches", static_cast<double>(network.branches) },
    { "loops", static_cast<double>(network.loops) },
    { "components", static_cast<double>(network.components) }, { "length", network.length } };
  if (network.resolution)
  {
    figures.emplace_back("resolution", *network.resolution);
  }
  return figures;
}

std::string whole(double value)
{
  return std::isnan(value) ? "-" : thousands(std::llround(value));
}

/// Lets the methods take turns.
Row race(const TriangleMesh& mesh, const std::vector<SkeletonMethodEntry>& methods,
  const Options& options)
{
  Row row;
  row.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  row.hasGrid = false;
  row.rounds = options.repeats;
  row.runs.resize(methods.size());
  std::vector<std::vector<double>> processor(methods.size());
  for (int round = 0; round < options.repeats; ++round)
  {
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
      MethodRun& run = row.runs[i];
      const std::unique_ptr<SkeletonMethod> method = methods[i].make();
      run.id = methods[i].id;
      run.name = method->name();
      double seconds = 0.0;
      const std::clock_t begin = std::clock(); // of all threads
      const Network network = timed(seconds, [&] { return method->compute(mesh); });
      processor[i].push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      run.samples.push_back({ { "total", seconds } });
      run.ratios.push_back(seconds / row.runs[0].samples[round].front().second);
      run.figures = figuresOf(network);
      run.figures.emplace_back("processor_seconds", median(processor[i]));
    }
  }
  return row;
}

Table emptyTable()
{
  Table table;
  table.columns = { "mesh", "triangles", "method", "grid points along the longest axis", "seconds",
    "over Medial", "processor seconds", "branches", "loops" };
  return table;
}

void addRows(const Row& row, Table& table)
{
  for (const MethodRun& run : row.runs)
  {
    table.rows.push_back({ row.mesh, thousands(row.triangles), run.name,
      whole(run.figure("resolution")), secondsText(run, row.rounds), number(median(run.ratios)),
      number(run.figure("processor_seconds")), whole(run.figure("branches")),
      whole(run.figure("loops")) });
    std::cerr << "  " << run.name << ": " << secondsText(run, row.rounds) << '\n';
  }
}

/// CGAL's seconds over those of a method of ours, which should be above 1.
Target fasterThanCgal(const Row& row, const MethodRun& ours, bool applies)
{
  Target target{ row.mesh, "CGAL's seconds over those of " + ours.name, Target::Kind::AtLeast,
    1.0 };
  if (const MethodRun* cgal = row.find(kCgalId))
  {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < ours.samples.size(); ++i)
    {
      ratios.push_back(sum(cgal->samples[i]) / sum(ours.samples[i]));
    }
    target.measured = median(ratios);
  }
  target.applies = applies;
  return target;
}

/// The same for processor seconds, which say less of cores and more of work.
Target lessWorkThanCgal(const Row& row, const MethodRun& ours, bool applies)
{
  Target target{ row.mesh, "CGAL's processor seconds over those of " + ours.name,
    Target::Kind::AtLeast, 1.0 };
  if (const MethodRun* cgal = row.find(kCgalId))
  {
    target.measured = cgal->figure("processor_seconds") / ours.figure("processor_seconds");
  }
  target.applies = applies;
  return target;
}

SuiteReport emptyReport(const Options& options)
{
  SuiteReport report;
  report.name = "skeletons";
  report.title = "Skeletons";
  report.usesRenderer = false;
  report.rounds = options.repeats;
  report.how =
    "Seconds are wall-clock, from the mesh in memory to the network, with the axis and the field "
    "that it needs. Medial uses all cores; CGAL's mean curvature skeleton one, and it takes one "
    "component at a time, so processor seconds, of all cores together, tell how much work it is. "
    "'auto' includes the coarse skeletons by which the resolution is chosen.";
  report.notes = { "`scripts/benchmark skeletons` makes this page." };
  report.tables = { emptyTable() };
  return report;
}

} // namespace

void runSkeletons(const SuiteContext& context)
{
  const Options& options = context.options();
  SuiteReport report = emptyReport(options);
  const std::vector<SkeletonMethodEntry> methods =
    availableMethods(context.resolution(kDefaultResolution));
  std::vector<std::string> built;
  for (const SkeletonMethodEntry& entry : methods)
  {
    built.push_back(entry.id);
  }
  SuiteContext::noteAbsent({ kCgalId }, built, report);
  for (MeshRequest request : meshes())
  {
    // Of the same shape in place of all meshes one is enough.
    if (!context.wantsMesh(request.name) || (options.quick && !report.rows.empty()))
    {
      continue;
    }
    request.triangles =
      options.quick ? std::min(request.triangles, kQuickTriangles) : request.triangles;
    const BenchmarkMesh input = provideMesh(request, options.quick);
    Row row = race(input.mesh, methods, options);
    row.mesh = request.name;
    row.note = input.generated ? "generated torus in its place" : "";
    std::cerr << row.mesh << '\n';
    addRows(row, report.tables.front());
    for (std::size_t i = 0; i < 2; ++i)
    {
      report.targets.push_back(fasterThanCgal(row, row.runs[i], context.targetsApply(row)));
      report.targets.push_back(lessWorkThanCgal(row, row.runs[i], context.targetsApply(row)));
    }
    report.rows.push_back(std::move(row));
    context.publish(report);
  }
}

} // namespace medial::benchmark

#include "suites/suite.h"

#include "base/stopwatch.h"
#include "base/vectors.h"
#include "clouds/cloud_registry.h"
#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

namespace medial::benchmark
{
namespace
{

constexpr std::size_t kPoints = 1000000;
constexpr std::size_t kQuickPoints = 2000;
constexpr int kQuickTriangles = 600;
/// How far points near the surface are from it at most, as a share of the diagonal.
constexpr double kNear = 0.005;

struct Cloud
{
  std::string name;
  std::vector<Point3> points;
};

Cloud randomCloud(const TriangleMesh& mesh, std::size_t count)
{
  const Bounds bounds = mesh.bounds();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Cloud cloud{ "random in the bounds", std::vector<Point3>(count) };
  for (Point3& point : cloud.points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = bounds.min[axis] + share(random) * (bounds.max[axis] - bounds.min[axis]);
    }
  }
  return cloud;
}

/// Points like those of a scan, in no order: off a random place of a random triangle.
Cloud nearCloud(const TriangleMesh& mesh, std::size_t count)
{
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::uniform_int_distribution<std::size_t> pick(0, mesh.triangles.size() - 1);
  const double off = kNear * mesh.bounds().diagonal() / std::sqrt(3.0);
  Cloud cloud{ "near the surface", std::vector<Point3>(count) };
  for (Point3& point : cloud.points)
  {
    const auto& [a, b, c] = mesh.triangles[pick(random)];
    const double root = std::sqrt(share(random));
    const double v = root * share(random);
    const glm::dvec3 place = (1.0 - root) * toVector(mesh.points[a]) +
      (root - v) * toVector(mesh.points[b]) + v * toVector(mesh.points[c]);
    const glm::dvec3 shift(share(random), share(random), share(random));
    point = toPoint(place + off * (2.0 * shift - 1.0));
  }
  return cloud;
}

std::vector<CloudMethodEntry> chosenMethods(const Options& options)
{
  std::vector<CloudMethodEntry> chosen;
  for (const CloudMethodEntry& entry : availableCloudMethods())
  {
    const auto& wanted = options.methods;
    if (wanted.empty() || entry.id == kMedialCloudId ||
      std::find(wanted.begin(), wanted.end(), entry.id) != wanted.end())
    {
      chosen.push_back(entry);
    }
  }
  return chosen;
}

/// Lets the methods take turns.
Row race(const TriangleMesh& mesh, const Cloud& cloud, const std::vector<CloudMethodEntry>& methods,
  int rounds)
{
  Row row;
  row.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  row.hasGrid = false;
  row.rounds = rounds;
  row.runs.resize(methods.size());
  std::vector<double> truth;
  for (int round = 0; round < rounds; ++round)
  {
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
      MethodRun& run = row.runs[i];
      const std::unique_ptr<CloudMethod> method = methods[i].make();
      run.id = methods[i].id;
      run.name = method->name();
      double build = 0.0;
      double query = 0.0;
      timed(build, [&] { method->start(mesh); });
      const std::vector<double> found =
        timed(query, [&] { return method->distances(cloud.points); });
      run.samples.push_back({ { "build", build }, { "query", query * method->sample() } });
      run.ratios.push_back(run.samples.back()[1].second / row.runs[0].samples.back()[1].second);
      if (round == 0)
      {
        truth = truth.empty() ? found : truth;
        double difference = 0.0;
        for (std::size_t k = 0; k < found.size(); ++k)
        {
          difference = std::fmax(difference, std::abs(found[k] - truth[k]));
        }
        run.figures = { { "difference", difference / mesh.bounds().diagonal() } };
      }
    }
  }
  return row;
}

Table emptyTable()
{
  Table table;
  table.columns = { "mesh and points", "triangles", "method", "build, s", "points, s", "us a point",
    "over Medial", "largest difference, of the diagonal" };
  return table;
}

void addRows(const Row& row, std::size_t points, Table& table)
{
  for (const MethodRun& run : row.runs)
  {
    const double query = run.medianPhase("query");
    const double difference = run.figure("difference");
    table.rows.push_back(
      { row.mesh, thousands(row.triangles), run.name, number(run.medianPhase("build")),
        number(query), number(1e6 * query / static_cast<double>(points)),
        number(median(run.ratios)), difference == 0.0 ? "0" : number(difference, 2) });
    std::cerr << "  " << run.name << ": " << number(query) << " s\n";
  }
}

} // namespace

void runPoints(const SuiteContext& context)
{
  const Options& options = context.options();
  const std::size_t count = options.quick ? kQuickPoints : kPoints;
  SuiteReport report;
  report.name = "points";
  report.title = "Distances of points";
  report.usesRenderer = false;
  report.rounds = options.repeats;
  report.how = "Seconds are wall-clock, on all cores, for " +
    thousands(static_cast<std::int64_t>(count)) +
    " points in no order; medians, and of the ratios, too. Medial sorts the points itself, which "
    "counts; 'points sorted' is Embree with the same sorting, where every point starts with the "
    "triangle of the one before. Embree computes in single precision. VTK computes one point in "
    "fifty.";
  report.notes = { "`scripts/benchmark points` makes this page." };
  std::vector<std::string> built;
  for (const CloudMethodEntry& entry : availableCloudMethods())
  {
    built.push_back(entry.id);
  }
  SuiteContext::noteAbsent(knownCloudMethodIds(), built, report);
  report.tables = { emptyTable() };
  for (MeshRequest request : { gargoyle(), dragon() })
  {
    if (!context.wantsMesh(request.name))
    {
      continue;
    }
    request.triangles =
      options.quick ? std::min(request.triangles, kQuickTriangles) : request.triangles;
    const BenchmarkMesh input = provideMesh(request, options.quick);
    for (const Cloud& cloud : { randomCloud(input.mesh, count), nearCloud(input.mesh, count) })
    {
      Row row = race(input.mesh, cloud, chosenMethods(options), options.repeats);
      row.mesh = request.name + ", " + cloud.name;
      row.note = input.generated ? "generated torus in its place" : "";
      std::cerr << row.mesh << '\n';
      addRows(row, count, report.tables.front());
      report.rows.push_back(std::move(row));
      context.publish(report);
    }
  }
}

} // namespace medial::benchmark

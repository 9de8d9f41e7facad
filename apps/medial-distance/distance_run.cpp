#include "distance_run.h"

#include "distance_outputs.h"
#include "distance_report.h"
#include "distance_results.h"
#include "input/surface_reader.h"
#include "interrupt.h"
#include "library_calls.h"
#include "output/json_output.h"
#include "scan_input.h"
#include "timer.h"

#include <utility>

namespace medial::app
{
namespace
{

SurfaceComparison compare(const DistanceCommand& command, const PointDistance& mesh,
  const MeshInput& points, ProgressBar& bar)
{
  SurfaceComparison comparison;
  TriangleMesh other;
  withFailures(command.points, [&] { other = buildTriangleMesh(points); });
  PartWatch there(bar, 0.6, 0.8, "comparing surfaces");
  withFailures(command.points,
    [&] {
      comparison.ofPoints = mesh.farthest(other, 1e-3, { command.threads, &there });
    });
  PartWatch back(bar, 0.8, 1.0, "comparing surfaces");
  withFailures(command.points,
    [&]
    {
      const PointDistance toPoints(std::move(other), SignMethod::None, { command.threads, &back });
      comparison.ofMesh = toPoints.farthest(mesh.mesh(), 1e-3, { command.threads, &back });
    });
  return comparison;
}

void compute(const DistanceCommand& command, TriangleMesh surface, const MeshInput& points,
  ProgressBar& bar, DistanceResults& results)
{
  const Timer timer;
  results.triangles = surface.triangles.size();
  results.vertices = surface.points.size();
  withFailures(command.mesh,
    [&]
    {
      PartWatch preparing(bar, 0.0, 0.2, "preparing");
      const PointDistance mesh(std::move(surface), command.sign, { command.threads, &preparing });
      results.sign = mesh.sign();
      PartWatch computing(bar, 0.2, 0.6, "distances");
      withFailures(command.points,
        [&] {
          results.distances = mesh.compute(results.points, { command.threads, &computing });
        });
      if (points.hasCells())
      {
        results.comparison = compare(command, mesh, points, bar);
      }
    });
  results.computeSeconds = timer.seconds();
}

} // namespace

void runDistance(const DistanceCommand& command)
{
  DistanceOutputs outputs(command); // what cannot be written is refused before anything is read
  ProgressBar bar(command.quiet);
  bar.show(0.0, "reading");
  const Timer reading;
  DistanceResults results;
  TriangleMesh surface;
  {
    Surface mesh = readSurface(command.mesh, command.scan);
    withFailures(command.mesh, [&] { surface = mesh.toTriangleMesh(); });
    if (!command.image.empty())
    {
      results.mesh = std::move(mesh);
    }
  }
  results.pointSet = readPointSet(command.points);
  const MeshInput points = results.pointSet.toMeshInput();
  results.points = points.points;
  results.readSeconds = reading.seconds();
  throwIfInterrupted();
  compute(command, std::move(surface), points, bar, results);
  outputs.write(results);
  bar.clear();
  printResult(
    command.json, command.quiet, [&] { return makeJson(command, results); },
    [&] { printTable(command, results); });
}

} // namespace medial::app

#include "medial/axis_measurement.h"

#include "base/vectors.h"
#include "medial/error.h"

#include "balls/ball_union.h"
#include "measure/boundary_samples.h"
#include "measure/sample_values.h"
#include "measure/surface_samples.h"
#include "medial/reconstruction.h"
#include "query/surface_query.h"
#include "sign/inside_query.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace medial
{
namespace
{

/// Points this near count as on a surface; a share of the diagonal of the bounds of the mesh.
constexpr double kTolerance = 1e-9;
/// The same for rounding; a share of the largest coordinate.
constexpr double kRounding = 1e-14;
/// Of LocalCoordinates::around().
constexpr double kMargin = 0.05;

double largestCoordinate(const Bounds& bounds)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max({ largest, std::abs(bounds.min[axis]), std::abs(bounds.max[axis]) });
  }
  return largest;
}

/// Returns by how much sparser to sample a union that is many times as large as the mesh: unbounded
/// radii must not take unbounded time.
double coarsening(const Bounds& solid, const Bounds& mesh)
{
  constexpr double kLargest = 4.0;
  const double ratio = solid.diagonal() / (kLargest * mesh.diagonal());
  return std::max(1.0, ratio * ratio);
}

/// Sums in order, so that the result is always the same.
Deviation summarise(const std::vector<double>& values)
{
  Deviation deviation;
  deviation.places = static_cast<std::int64_t>(values.size());
  for (const double value : values)
  {
    deviation.max = std::max(deviation.max, value);
    deviation.mean += value;
  }
  deviation.mean /= std::max<double>(1.0, static_cast<double>(values.size()));
  return deviation;
}

Deviation surfaceToUnion(const TriangleMesh& mesh, const BallUnion& solid, std::int64_t count,
  double tolerance, const Run& run)
{
  const auto distance = [&](const glm::dvec3& x) { return solid.distanceToSurface(x, tolerance); };
  const std::vector<glm::dvec3> samples = surfaceSamples(mesh, count);
  Deviation deviation = summarise(sampleValues(run.part(0.0, 0.75), samples.size(),
    "surface to union", [&](std::size_t i) { return distance(samples[i]); }));
  const std::vector<double> atPoints = sampleValues(run.part(0.75, 1.0), mesh.points.size(),
    "surface to union", [&](std::size_t i) { return distance(toVector(mesh.points[i])); });
  deviation.max = std::max(deviation.max, summarise(atPoints).max);
  return deviation;
}

Deviation unionToSurface(const SurfaceQuery& surface, const BoundarySamples& boundary,
  const Run& run)
{
  const auto distances = [&](const std::vector<glm::dvec3>& points, const Run& part)
  {
    return summarise(sampleValues(part, points.size(), "union to surface",
      [&](std::size_t i) {
        return surface.distance({ points[i].x, points[i].y, points[i].z });
      }));
  };
  Deviation deviation = distances(boundary.even, run.part(0.0, 0.75));
  const Deviation ofBalls = distances(boundary.ofBalls, run.part(0.75, 1.0));
  if (boundary.even.empty())
  {
    return ofBalls; // a union without area
  }
  deviation.max = std::max(deviation.max, ofBalls.max);
  return deviation;
}

void compareBalls(const MedialModel& model, const SurfaceQuery& surface, const InsideQuery& inside,
  const Run& run, AxisMeasurement& result)
{
  const std::vector<double> distances = sampleValues(run, model.centres.size(), "radii",
    [&](std::size_t i) { return surface.distance(model.centres[i]); });
  std::vector<double> errors(distances.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    errors[i] = std::abs(distances[i] - model.radii[i]);
  }
  if (result.knowsInside)
  {
    const std::vector<double> sides = sampleValues(run, model.centres.size(), "radii",
      [&](std::size_t i)
      { return inside.contains(surface.local().toLocal(model.centres[i])) ? -1.0 : 1.0; });
    result.centresInside = std::count(sides.begin(), sides.end(), -1.0);
  }
  result.radiusError = summarise(errors);
}

AxisMeasurement measure(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const MedialModel& model, const MeasurementOptions& options, const Run& run)
{
  run.report(0.0, "preparing");
  AxisMeasurement result;
  result.counts = countModel(model);
  const double area = surfaceArea(mesh);
  if (!(area > 0.0))
  {
    throw Error(ErrorCode::InvalidInput, "the mesh has an area of 0");
  }
  result.diagonal = mesh.bounds().diagonal();
  const Bounds bounds = mesh.bounds();
  const double tolerance =
    std::max(kTolerance * result.diagonal, kRounding * largestCoordinate(bounds));
  const BallUnion solid(model);
  const SurfaceQuery surface(mesh, connectivity, kMargin);
  const InsideQuery inside(mesh, connectivity, surface.local());
  result.knowsInside = inside.closed();
  result.surfaceToUnion =
    surfaceToUnion(mesh, solid, options.samples, tolerance, run.part(0.1, 0.5));
  const double perSample =
    area / static_cast<double>(options.samples) * coarsening(modelBounds(model), bounds);
  const BoundarySamples boundary = boundarySamples(solid, perSample, tolerance,
    [&](double fraction) { run.part(0.5, 0.7).report(fraction, "surface of the union"); });
  result.unionToSurface = unionToSurface(surface, boundary, run.part(0.7, 0.9));
  compareBalls(model, surface, inside, run.part(0.9, 1.0), result);
  run.report(1.0, "radii");
  return result;
}

} // namespace

double AxisMeasurement::hausdorff() const
{
  return std::max(surfaceToUnion.max, unionToSurface.max);
}

double AxisMeasurement::meanDistance() const
{
  return 0.5 * (surfaceToUnion.mean + unionToSurface.mean);
}

AxisMeasurement measureAxis(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const MedialModel& model, const MeasurementOptions& options)
{
  checkSampleCount(options.samples);
  const Run run(options.execution);
  return run.onThreads([&] { return measure(mesh, connectivity, model, options, run); });
}

} // namespace medial

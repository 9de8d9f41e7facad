#include "medial/medial/evaluation/axis_evaluation.h"

#include "medial/medial/evaluation/ball_union.h"
#include "medial/medial/evaluation/boundary_samples.h"
#include "medial/medial/evaluation/evaluation_steps.h"
#include "medial/medial/evaluation/surface_distance.h"
#include "medial/medial/evaluation/surface_samples.h"
#include "medial/medial/evaluation/union_field.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace medial
{
namespace
{

/// What counts as on a surface, of the diagonal of the mesh's bounds.
constexpr double kTolerance = 1e-9;
/// The same, of the greatest coordinate: what rounding may do.
constexpr double kRounding = 1e-14;

glm::dvec3 toVector(const Point3& point)
{
  return { point[0], point[1], point[2] };
}

double largestCoordinate(const Bounds& bounds)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max({ largest, std::abs(bounds.min[axis]), std::abs(bounds.max[axis]) });
  }
  return largest;
}

/// By how much sparser a union has to be sampled that is many times as large as the mesh: radii
/// without bounds must not take time without bounds.
double coarsening(const Bounds& solid, const Bounds& mesh)
{
  constexpr double kLargest = 4.0;
  const double ratio = solid.diagonal() / (kLargest * mesh.diagonal());
  return std::max(1.0, ratio * ratio);
}

/// Summed in order, so that the result is always the same.
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
  double tolerance, Steps& steps)
{
  const auto distance = [&](const glm::dvec3& x) { return solid.distanceToSurface(x, tolerance); };
  const std::vector<glm::dvec3> samples = surfaceSamples(mesh, count);
  Deviation deviation = summarise(steps.evaluate(samples.size(), 0.1, 0.4, "surface to union",
    [&](std::size_t i) { return distance(samples[i]); }));
  const std::vector<double> atPoints = steps.evaluate(mesh.points.size(), 0.4, 0.5,
    "surface to union", [&](std::size_t i) { return distance(toVector(mesh.points[i])); });
  deviation.max = std::max(deviation.max, summarise(atPoints).max);
  return deviation;
}

void compareBalls(const MedialModel& model, const SurfaceDistance& surface, Steps& steps,
  AxisEvaluation& result)
{
  const std::vector<double> distances = steps.evaluate(model.centres.size(), 0.9, 1.0, "radii",
    [&](std::size_t i) { return surface.signedDistance(toVector(model.centres[i])); });
  std::vector<double> errors(distances.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    errors[i] = std::abs(std::abs(distances[i]) - model.radii[i]);
    result.centresInside += distances[i] < 0.0 ? 1 : 0;
  }
  result.radiusError = summarise(errors);
}

AxisEvaluation evaluate(const TriangleMesh& mesh, const MeshTopology& topology,
  const MedialModel& model, const EvaluationOptions& options)
{
  Steps steps(options.progress);
  steps.report(0.0, "preparing");
  AxisEvaluation result;
  result.topology = analyseModel(model);
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
  const SurfaceDistance surface(mesh, topology);
  result.knowsInside = surface.knowsInside();
  result.surfaceToUnion = surfaceToUnion(mesh, solid, options.samples, tolerance, steps);
  const double perSample =
    area / static_cast<double>(options.samples) * coarsening(modelBounds(model), bounds);
  const std::vector<glm::dvec3> boundary = boundarySamples(solid, perSample, tolerance,
    [&](double fraction) { steps.report(0.5 + 0.2 * fraction, "surface of the union"); });
  result.unionToSurface = summarise(steps.evaluate(boundary.size(), 0.7, 0.9, "union to surface",
    [&](std::size_t i) { return std::abs(surface.signedDistance(boundary[i])); }));
  compareBalls(model, surface, steps, result);
  steps.report(1.0, "radii");
  return result;
}

} // namespace

double AxisEvaluation::hausdorff() const
{
  return std::max(surfaceToUnion.max, unionToSurface.max);
}

double AxisEvaluation::meanDistance() const
{
  return 0.5 * (surfaceToUnion.mean + unionToSurface.mean);
}

AxisEvaluation evaluateAxis(const TriangleMesh& mesh, const MeshTopology& topology,
  const MedialModel& model, const EvaluationOptions& options)
{
  checkEvaluation(options);
  return onThreads(options.threads, [&] { return evaluate(mesh, topology, model, options); });
}

} // namespace medial

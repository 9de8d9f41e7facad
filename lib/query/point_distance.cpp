#include "medial/point_distance.h"

#include "base/checkpoint.h"
#include "base/hilbert_curve.h"
#include "base/order_statistics.h"
#include "base/run.h"
#include "base/vectors.h"
#include "medial/error.h"
#include "query/distance_query.h"
#include "query/farthest_point.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <utility>

namespace medial
{
namespace
{

constexpr const char* kPhase = "distances";
/// Points that one thread computes together, along a curve.
constexpr std::size_t kTogether = 512;

/// Returns the indices of points so that neighbours are close together.
std::vector<std::size_t> orderOf(const std::vector<glm::dvec3>& points)
{
  glm::dvec3 low = points.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& x : points)
  {
    low = glm::min(low, x);
    high = glm::max(high, x);
  }
  const HilbertCurve curve(low, high);
  std::vector<std::pair<std::uint64_t, std::size_t>> places(points.size());
  tbb::parallel_for(std::size_t{ 0 }, points.size(),
    [&](std::size_t i) {
      places[i] = { curve.placeOf(points[i]), i };
    });
  tbb::parallel_sort(places.begin(), places.end());
  std::vector<std::size_t> order(points.size());
  std::transform(places.begin(), places.end(), order.begin(),
    [](const auto& place) { return place.second; });
  return order;
}

std::vector<glm::dvec3> toLocal(const std::vector<Point3>& points, const LocalCoordinates& local)
{
  std::vector<glm::dvec3> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    requireUsable(i, points[i]);
    result[i] = local.toLocal(points[i]);
  }
  return result;
}

void resize(std::size_t count, PointDistances& result)
{
  result.distance.resize(count);
  result.closestPoint.resize(count);
  result.closestCell.resize(count);
  result.closestFeature.resize(count);
  result.direction.resize(count);
}

/// Returns the world coordinates of a surface point; of a vertex those of the mesh, to the last
/// bit.
Point3 worldPoint(const DistanceQuery& query, const SitePoint& closest)
{
  const int vertex = closest.site - query.sites().firstVertex();
  return vertex >= 0 ? query.mesh().points[vertex] : query.local().toWorld(closest.point);
}

void store(const DistanceQuery& query, std::size_t i, const glm::dvec3& x, const SitePoint& closest,
  bool inside, PointDistances& result)
{
  const glm::dvec3 vector = closest.point - x;
  const double distance = glm::length(vector);
  const bool negative = inside && distance > 0.0;
  result.distance[i] = (negative ? -distance : distance) * query.local().unit;
  result.closestPoint[i] = worldPoint(query, closest);
  result.closestCell[i] = query.cells().cellOf(closest.site);
  result.closestFeature[i] = query.cells().featureOf(closest.site);
  result.direction[i] = toPoint(distance > 0.0 ? vector / distance : glm::dvec3(0.0));
}

void computeDistances(const DistanceQuery& query, const std::vector<Point3>& points, const Run& run,
  PointDistances& result)
{
  const std::vector<glm::dvec3> positions = toLocal(points, query.local());
  resize(points.size(), result);
  const std::vector<std::size_t> order = orderOf(positions);
  const Checkpoint checkpoint(run, 0.5, kPhase);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, order.size(), kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      checkpoint();
      std::vector<SiteQuery::Question> questions;
      for (std::size_t k = range.begin(); k != range.end(); ++k)
      {
        questions.push_back({ positions[order[k]], {} });
      }
      query.query().closest(questions);
      PointSide::Known known;
      for (std::size_t k = range.begin(); k != range.end(); ++k)
      {
        const auto& [x, closest, other] = questions[k - range.begin()];
        store(query, order[k], x, closest, query.side().contains(x, closest, known), result);
      }
    });
}

/// Runs `work` on the threads of a run, and says what for if memory runs out.
template <typename Work>
auto onThreads(const Run& run, const std::string& what, const Work& work)
{
  try
  {
    return run.onThreads(work);
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory, "out of memory for the distances of " + what);
  }
}

/// Returns the smallest of some magnitudes that no more than a share of them exceed.
double quantile(std::vector<double>& magnitudes, double exceeding)
{
  return valueAt(magnitudes, indexBefore(exceeding, static_cast<std::int64_t>(magnitudes.size())));
}

} // namespace

DistanceSummary summarise(const PointDistances& distances)
{
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double>& values = distances.distance;
  if (values.empty())
  {
    return { kNone, kNone, kNone, kNone, kNone, kNone };
  }
  DistanceSummary summary;
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  summary.min = *min;
  summary.max = *max;
  const double count = static_cast<double>(values.size());
  // By the largest, so that no square is too large.
  const double scale = std::max({ std::abs(*min), std::abs(*max), 1e-300 });
  for (const double value : values)
  {
    summary.mean += std::abs(value) / count;
    summary.rms += value / scale * (value / scale) / count;
  }
  summary.rms = scale * std::sqrt(summary.rms);
  std::vector<double> magnitudes(values.size());
  std::transform(values.begin(), values.end(), magnitudes.begin(),
    [](double value) { return std::abs(value); });
  summary.median = quantile(magnitudes, 0.5);
  summary.percentile95 = quantile(magnitudes, 0.05);
  return summary;
}

struct PointDistance::State
{
  State(TriangleMesh mesh, SignMethod sign, const Run& run, const Execution& execution)
    : query(std::move(mesh), sign, run, execution)
  {
  }

  DistanceQuery query;
};

PointDistance::PointDistance(TriangleMesh mesh, SignMethod sign, const Execution& execution)
{
  const Run run(execution);
  const std::string what = "a mesh of " + std::to_string(mesh.points.size()) + " points";
  onThreads(run, what,
    [&] { state_ = std::make_unique<const State>(std::move(mesh), sign, run, execution); });
}

PointDistance::~PointDistance() = default;
PointDistance::PointDistance(PointDistance&& other) noexcept = default;
PointDistance& PointDistance::operator=(PointDistance&& other) noexcept = default;

const TriangleMesh& PointDistance::mesh() const
{
  return state_->query.mesh();
}

const MeshConnectivity& PointDistance::connectivity() const
{
  return state_->query.connectivity();
}

const SignReport& PointDistance::sign() const
{
  return state_->query.sign();
}

PointDistances PointDistance::compute(const std::vector<Point3>& points,
  const Execution& execution) const
{
  const Run run(execution);
  run.report(0.0, kPhase);
  PointDistances result;
  if (!points.empty())
  {
    onThreads(run, std::to_string(points.size()) + " points",
      [&] { computeDistances(state_->query, points, run, result); });
  }
  run.report(1.0, kPhase);
  return result;
}

FarthestPoint PointDistance::farthest(const TriangleMesh& surface, double tolerance,
  const Execution& execution) const
{
  checkTolerance(tolerance);
  const Run run(execution);
  run.report(0.0, kPhase);
  const FarthestPoint result = onThreads(run, std::to_string(surface.points.size()) + " points",
    [&] { return farthestPoint(state_->query, surface, tolerance, Checkpoint(run, 0.5, kPhase)); });
  run.report(1.0, kPhase);
  return result;
}

} // namespace medial

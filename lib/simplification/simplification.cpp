#include "medial/simplification.h"

#include "balls/ball_union.h"
#include "base/range_check.h"
#include "base/stopwatch.h"
#include "medial/error.h"
#include "simplification/axis_balls.h"
#include "simplification/ball_fit.h"
#include "simplification/boundary_planes.h"
#include "simplification/component_links.h"
#include "simplification/edge_collapse.h"
#include "simplification/simplified_axis.h"
#include "simplification/simplify_axis.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// How far a ball may extend beyond the surface, as a share of its radius. A smaller share makes
/// both one-sided distances worse, since the fit is balanced. Mean S->U and U->S of the hand with
/// 50 balls: no limit 0.226 and 0.210 % of the diagonal, a tenth 0.230 and 0.213, zero 0.363 and
/// 0.333.
constexpr double kReach = 0.25;

std::vector<BallQuadric> quadricsOf(const std::vector<TangentPlane>& planes, std::size_t vertices)
{
  std::vector<BallQuadric> quadrics(vertices);
  for (const TangentPlane& plane : planes)
  {
    quadrics[plane.vertex].addPlane(plane.point, plane.normal, plane.weight);
  }
  return quadrics;
}

std::int64_t componentCount(const BallComplex& complex)
{
  const std::vector<int> labels = componentsOf(complex);
  std::int64_t count = 0;
  for (std::size_t v = 0; v < labels.size(); ++v)
  {
    count += labels[v] == static_cast<int>(v) ? 1 : 0;
  }
  return count;
}

/// Removes the smallest balls of a complex without edges, until `target` are left.
/// @return the number of balls removed.
std::int64_t dropSmallest(const std::vector<Ball>& balls, int target, BallComplex& complex)
{
  std::vector<int> left = complex.vertices();
  if (left.size() <= static_cast<std::size_t>(target))
  {
    return 0;
  }
  std::sort(left.begin(), left.end(),
    [&balls](int a, int b)
    { return std::make_pair(-balls[a].radius, a) < std::make_pair(-balls[b].radius, b); });
  std::for_each(left.begin() + target, left.end(),
    [&complex](int vertex) { complex.removeVertex(vertex); });
  return static_cast<std::int64_t>(left.size()) - target;
}

/// Limits how far balls extend beyond the closest points of the axis, which sample the surface.
void limitRadii(const MedialAxis& axis, const AxisBalls& frame, const BallComplex& complex,
  std::vector<Ball>& balls)
{
  std::vector<Ball> surface;
  for (const auto* points : { &axis.closestPointA, &axis.closestPointB })
  {
    for (const auto& p : *points)
    {
      surface.push_back({ frame.toLocal(p), 0.0 });
    }
  }
  const BallUnion samples(std::move(surface));
  for (const int v : complex.vertices())
  {
    Ball& ball = balls[v];
    const double inside = samples.nearest(ball.centre, ball.radius).distance;
    ball.radius = std::min(ball.radius, inside + kReach * ball.radius);
  }
}

class Simplifier
{
public:
  Simplifier(const MedialAxis& axis, std::int64_t maxSpheres, const Run& run)
    : axis_(axis)
    , maxSpheres_(maxSpheres)
    , run_(run)
    , frame_(ballsOf(axis))
    , balls_(frame_.balls)
    , complex_(complexOf(axis, balls_))
  {
  }

  MedialAxis run()
  {
    statistics_.inputPoints = static_cast<std::int64_t>(balls_.size());
    statistics_.inputComponents = componentCount(complex_);
    statistics_.components = statistics_.inputComponents;
    this->report(0.0);
    if (statistics_.inputPoints <= maxSpheres_)
    {
      MedialAxis same = axis_;
      same.simplification = statistics_;
      return same;
    }
    this->simplify();
    statistics_.components = componentCount(complex_);
    limitRadii(axis_, frame_, complex_, balls_);
    MedialAxis result = simplifiedAxis(axis_, frame_, { balls_, complex_, representatives_ });
    result.simplification = statistics_;
    this->report(1.0);
    return result;
  }

private:
  void report(double fraction) const { run_.report(fraction, "simplification"); }

  void simplify()
  {
    std::vector<TangentPlane> planes;
    run_.onThreads(
      [&] { planes = boundaryPlanes(balls_, closestPairsOf(axis_, frame_), complex_); });
    this->report(0.2);
    statistics_.joined = linkComponents(balls_, complex_);
    this->report(0.3);
    std::optional<EdgeCollapse> collapse;
    run_.onThreads([&] { collapse.emplace(balls_, quadricsOf(planes, balls_.size()), complex_); });
    this->report(0.4);
    this->reduce(*collapse);
    representatives_ = collapse->representatives();
    const auto fitted = [this](double share) { this->report(0.7 + 0.3 * share); };
    run_.onThreads([&] { fitBalls(planes, representatives_, complex_, balls_, fitted); });
  }

  void reduce(EdgeCollapse& collapse)
  {
    const auto step = [this](int left)
    {
      const double share = static_cast<double>(left) / static_cast<double>(balls_.size());
      this->report(0.7 - 0.3 * share);
    };
    const int target =
      static_cast<int>(std::min<std::int64_t>(maxSpheres_, std::numeric_limits<int>::max()));
    // In an axis with the topology of its solid, loops belong to the solid.
    const bool fill = !axis_.solid;
    collapse.reduceTo(target, { fill, false, false }, step);
    collapse.reduceTo(target, { fill, true, false }, step);
    const int left = collapse.reduceTo(target, { true, true, false }, step);
    statistics_.forced = left - collapse.reduceTo(target, { true, true, true }, step);
    statistics_.dropped = dropSmallest(balls_, target, complex_);
    this->report(0.7);
  }

  const MedialAxis& axis_;
  std::int64_t maxSpheres_;
  const Run& run_;
  const AxisBalls frame_;
  std::vector<Ball> balls_;
  BallComplex complex_;
  std::vector<int> representatives_;
  SimplificationStatistics statistics_;
};

} // namespace

MedialAxis simplifyAxis(const MedialAxis& axis, std::int64_t maxSpheres, const Run& run)
{
  if (maxSpheres < 1)
  {
    throwOutside("maximum number of spheres", maxSpheres, "[1, infinity)");
  }
  double seconds = 0.0;
  MedialAxis result = timed(seconds, [&] { return Simplifier(axis, maxSpheres, run).run(); });
  result.simplification.seconds = seconds;
  return result;
}

MedialAxis simplifyAxis(const MedialAxis& axis, const SimplificationOptions& options)
{
  return simplifyAxis(axis, options.maxSpheres, Run(options.execution));
}

} // namespace medial

#include "thinning/curve_finish.h"

#include "axis/closest_pairs.h"
#include "axis/smooth_curve.h"
#include "axis/widest_place.h"
#include "medial/axis_curves.h"
#include "sites/closest_point.h"
#include "thinning/sound_cells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{
namespace
{

/// Shorter curves are left as they are.
constexpr std::size_t kMinPoints = 4;
/// How many points count on either side of one, at least, and as a part of the radius.
constexpr double kMinReach = 6.0;
constexpr double kReachOfRadius = 0.75;
constexpr int kMaxReach = 100;
/// How near to the widest place of a cross-section a point is moved, voxels.
constexpr double kPrecision = 0.005;
/// Points that are farther from where thinning has left them, in voxels, have lost their way.
constexpr double kFarthest = 4.0;
/// Points at free ends that are placed anew, and by how much they may lengthen the curve, voxels.
constexpr std::size_t kEndPoints = 6;
constexpr double kMaxExtension = 2.0;
/// How far beyond a curve its far side is looked for: a part of the radius, and voxels.
constexpr double kBeyond = 0.5;
constexpr double kNotFar = 0.8;

using Closest = std::function<SitePoint(const glm::dvec3& x, const SitePoint& known)>;

/// Whether the line between two points cannot leave the solid.
bool overlap(const BisectorPoint& p, const BisectorPoint& q)
{
  return glm::distance(p.position, q.position) < p.radius() + q.radius();
}

/// Adds the parts of a curve that have a zigzag. Where balls do not overlap, it may leave the solid
/// through a gap narrower than a voxel; its parts end there.
void addCurves(std::vector<std::int64_t> path, const std::vector<AxisFeature>& features,
  const std::vector<BisectorPoint>& points, std::vector<FreeCurve>& curves)
{
  bool stays = features[path.front()] == AxisFeature::Junction;
  const bool closed = path.front() == path.back() && !stays;
  if (closed)
  {
    const auto leap = std::adjacent_find(path.begin(), path.end(),
      [&](std::int64_t p, std::int64_t q) { return !overlap(points[p], points[q]); });
    stays = leap != path.end();
    if (stays)
    {
      std::rotate(path.begin(), leap + 1, path.end() - 1);
    }
    path.pop_back();
  }
  FreeCurve part;
  part.curve.closed = closed && !stays;
  part.firstStays = stays;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    part.points.push_back(path[i]);
    part.curve.points.push_back(points[path[i]].position);
    const bool last = i + 1 == path.size();
    if (last || !overlap(points[path[i]], points[path[i + 1]]))
    {
      part.lastStays = !last || (closed ? stays : features[path[i]] == AxisFeature::Junction);
      if (part.points.size() >= kMinPoints)
      {
        curves.push_back(part);
      }
      part = {};
      part.firstStays = true;
    }
  }
}

class Finisher
{
public:
  Finisher(const AxisGeometry& geometry, const std::vector<BisectorPoint>& points,
    const Closest& closest)
    : geometry_(geometry)
    , points_(points)
    , closest_(closest)
  {
  }

  /// Moves the points of a curve.
  void straighten(FreeCurve& free) const
  {
    Curve& curve = free.curve;
    const Curve before = curve;
    const std::vector<int> reaches = this->reachesOf(free);
    moveTo(smoothed(curve, reaches), curve);
    this->placeEnds(free);
    this->centre(reaches, curve);
    moveTo(smoothed(curve, reaches), curve);
    this->placeEnds(free);
    leadToEnds(before, free);
    for (std::size_t i = 0; i < curve.points.size(); ++i)
    {
      if (glm::distance(curve.points[i], before.points[i]) > kFarthest ||
        !geometry_.insideGrid(curve.points[i]))
      {
        curve.points[i] = before.points[i];
      }
    }
  }

  /// Returns the points of a curve with their closest pairs; those that have not moved as they
  /// were.
  std::vector<BisectorPoint> pairs(const FreeCurve& free) const
  {
    std::vector<BisectorPoint> pairs(free.points.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      const BisectorPoint& before = points_[free.points[i]];
      const bool stays = (i == 0 && free.firstStays) || (i + 1 == pairs.size() && free.lastStays) ||
        free.curve.points[i] == before.position;
      pairs[i] = stays ? before : this->pairAt(free, i);
    }
    return pairs;
  }

private:
  /// Returns the closest pair at a point of a curve.
  BisectorPoint pairAt(const FreeCurve& free, std::size_t i) const
  {
    const glm::dvec3& x = free.curve.points[i];
    const BisectorPoint& before = points_[free.points[i]];
    const SitePoint closest = closest_(x, closestPoint(geometry_.sites, before.a.site, x));
    std::vector<int> candidates{ before.a.site, before.b.site };
    // What is closest on the far side of the curve: from x at most twice the way there farther.
    for (const double beyond : { kBeyond, std::min(kBeyond, kNotFar / before.radius()) })
    {
      const glm::dvec3 far = x + beyond * (x - closest.point);
      const SitePoint guess = closestPoint(geometry_.sites, candidates.back(), far);
      candidates.push_back(geometry_.insideGrid(far) ? closest_(far, guess).site : closest.site);
    }
    for (const double tolerance : { kOffBisector, 1.0 })
    {
      const SitePoint opposite = oppositePoint(geometry_.sites, candidates, x, closest, tolerance);
      if (opposite.site != closest.site)
      {
        return { x, closest, opposite };
      }
    }
    return { x, closest, closestPoint(geometry_.sites, candidates.back(), x) };
  }

  static void moveTo(const std::vector<CurvePoint>& fitted, Curve& curve)
  {
    std::transform(fitted.begin(), fitted.end(), curve.points.begin(),
      [](const CurvePoint& point) { return point.position; });
  }

  /// Moves points to the widest places of their cross-sections.
  void centre(const std::vector<int>& reaches, Curve& curve) const
  {
    const std::vector<CurvePoint> fitted = smoothed(curve, reaches);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, fitted.size()),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        SitePoint known;
        const auto closest = [&](const glm::dvec3& x)
        {
          known = known.site < 0 ? SitePoint{} : closestPoint(geometry_.sites, known.site, x);
          known = closest_(x, known);
          return known.point;
        };
        for (std::size_t i = range.begin(); i < range.end(); ++i)
        {
          if (geometry_.insideGrid(curve.points[i]))
          {
            curve.points[i] = widestPlace(curve.points[i], fitted[i].tangent, kPrecision, closest);
          }
        }
      });
  }

  /// Puts the points at free ends on the line that the curve leads to there, as far as the radius
  /// falls no faster than curves of the minimum angle let it: there is nothing to fit beyond the
  /// end, and voxels may have left too much or too little of the curve.
  void placeEnds(FreeCurve& free) const
  {
    Curve& curve = free.curve;
    if (curve.closed)
    {
      return;
    }
    for (const bool stays : { free.lastStays, free.firstStays })
    {
      if (!stays)
      {
        this->placeLast(curve.points);
      }
      std::reverse(curve.points.begin(), curve.points.end());
    }
  }

  void placeLast(std::vector<glm::dvec3>& points) const
  {
    const std::size_t count = points.size();
    const std::size_t moving = std::min(kEndPoints, count / 3);
    const std::size_t used = std::min(2 * kEndPoints, count - moving);
    const std::size_t anchor = count - 1 - moving;
    glm::dvec3 slope(0.0);
    for (std::size_t i = 0; i < used; ++i)
    {
      slope += (0.5 * static_cast<double>(used - 1) - static_cast<double>(i)) * points[anchor - i];
    }
    const double norm = glm::length(slope);
    if (moving == 0 || !(norm > 0.0))
    {
      return;
    }
    const glm::dvec3 direction = slope / norm;
    const double end = this->endAlong(points[anchor], direction,
      glm::distance(points[anchor], points.back()) + kMaxExtension);
    for (std::size_t i = 1; i <= moving; ++i)
    {
      points[anchor + i] =
        points[anchor] + end * static_cast<double>(i) / static_cast<double>(moving) * direction;
    }
  }

  /// Returns how far a curve leads from a point, at most `high`.
  double endAlong(const glm::dvec3& from, const glm::dvec3& direction, double high) const
  {
    constexpr double kStep = 0.05;
    // Radii fall as fast as the way is long where balls end.
    constexpr double kSteepest = 0.9;
    const double slope = std::min(std::cos(0.5 * geometry_.limits.angle), kSteepest);
    double best = kStep;
    double most = 0.0;
    for (int i = 1; i * kStep <= high; ++i)
    {
      const glm::dvec3 x = from + i * kStep * direction;
      const double potential = glm::distance(closest_(x, {}).point, x) + slope * i * kStep;
      if (geometry_.insideGrid(x) && potential > most)
      {
        most = potential;
        best = i * kStep;
      }
    }
    return best;
  }

  std::vector<int> reachesOf(const FreeCurve& free) const
  {
    std::vector<int> reaches;
    for (const std::int64_t point : free.points)
    {
      const double reach = std::max(kMinReach, kReachOfRadius * points_[point].radius());
      reaches.push_back(std::min(kMaxReach, static_cast<int>(std::lround(reach))));
    }
    return reaches;
  }

  /// Bends the ends of a curve to those that must stay.
  static void leadToEnds(const Curve& before, FreeCurve& free)
  {
    std::vector<glm::dvec3>& points = free.curve.points;
    const std::size_t count = points.size();
    const glm::dvec3 first =
      free.firstStays ? before.points.front() - points.front() : glm::dvec3(0.0);
    const glm::dvec3 last = free.lastStays ? before.points.back() - points.back() : glm::dvec3(0.0);
    const std::size_t length =
      std::min(count - 1, static_cast<std::size_t>(std::lround(kMinReach)));
    for (std::size_t i = 0; i < length; ++i)
    {
      const double share = 1.0 - static_cast<double>(i) / static_cast<double>(length);
      points[i] += share * share * first;
      points[count - 1 - i] += share * share * last;
    }
  }

  const AxisGeometry& geometry_;
  const std::vector<BisectorPoint>& points_;
  const Closest& closest_;
};

/// Moves points of a curve back until it cannot leave the solid between any two.
void keepInside(const FreeCurve& free, const std::vector<BisectorPoint>& before,
  std::vector<BisectorPoint>& points)
{
  const std::size_t count = points.size();
  for (bool changed = true; changed;)
  {
    changed = false;
    for (std::size_t i = 0; i + (free.curve.closed ? 0 : 1) < count; ++i)
    {
      if (overlap(points[i], points[(i + 1) % count]))
      {
        continue;
      }
      for (const std::size_t k : { i, (i + 1) % count })
      {
        const BisectorPoint& old = before[free.points[k]];
        changed = changed || points[k].position != old.position;
        points[k] = old;
      }
    }
  }
}

} // namespace

std::vector<FreeCurve> zigzagCurves(const ThinnedAxis& axis)
{
  AxisEdges edges;
  edges.lines = axis.lines;
  std::vector<std::uint8_t> onLine(axis.points.points.size(), 0);
  for (const auto& line : axis.lines)
  {
    onLine[line[0]] = 1;
    onLine[line[1]] = 1;
  }
  for (const auto& quad : axis.quads)
  {
    if (std::any_of(quad.begin(), quad.end(),
          [&](std::int64_t corner) { return onLine[corner] != 0; }))
    {
      addEdges(quad, edges.polygonEdges);
    }
  }
  const std::vector<AxisFeature> features = axisFeatures(edges, onLine.size());
  std::vector<FreeCurve> curves;
  for (const AxisCurve& path : axisCurves(edges, onLine.size()))
  {
    if (path.kind == AxisFeature::Curve)
    {
      addCurves(path.points, features, axis.points.points, curves);
    }
  }
  return curves;
}

std::vector<BisectorPoint> withoutZigzag(const AxisGeometry& geometry, FreeCurve curve,
  const std::vector<BisectorPoint>& before, const Closest& closest)
{
  geometry.checkpoint();
  const Finisher finisher(geometry, before, closest);
  finisher.straighten(curve);
  std::vector<BisectorPoint> moved = finisher.pairs(curve);
  keepInside(curve, before, moved);
  return moved;
}

void finishCurves(const AxisGeometry& geometry, ThinnedAxis& axis)
{
  const std::vector<FreeCurve> curves = zigzagCurves(axis);
  const std::vector<BisectorPoint> before = axis.points.points;
  const Closest closest = [&](const glm::dvec3& x, const SitePoint& known)
  { return geometry.query.closest(x, known); };
  tbb::parallel_for(std::size_t{ 0 }, curves.size(),
    [&](std::size_t c)
    {
      const std::vector<BisectorPoint> moved = withoutZigzag(geometry, curves[c], before, closest);
      for (std::size_t i = 0; i < moved.size(); ++i)
      {
        axis.points.points[curves[c].points[i]] = moved[i];
      }
    });
  keepCellsSound(before, axis);
}

} // namespace medial

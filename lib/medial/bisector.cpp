#include "medial/medial/bisector.h"

#include "medial/medial/separation.h"
#include "medial/sites/closest_point.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// A nearer third site counts from this difference on, in frame units (voxels).
constexpr double kSameDistance = 1e-6;
/// Medial balls smaller than this (voxels) are the surface itself.
constexpr double kLeastRadius = 1e-3;
/// Where two sites are this much (voxels) farther than the closest one, their separation angle
/// counts if that of the closest ones is too small: all facets of a round surface have bisectors of
/// their own, which part at its centre.
constexpr double kFacets = 0.1;
/// Sites between the two that are looked for at most.
constexpr int kMaxRounds = 8;

/// The part of a segment that is known to hold a change from siteA to siteB.
class Change
{
public:
  Change(const SiteSet& sites, const glm::dvec3& from, int siteA, const glm::dvec3& to, int siteB)
    : sites_(sites)
    , start_(from)
    , along_(to - from)
    , siteA_(siteA)
    , siteB_(siteB)
  {
  }

  /// Goes to the point at equal distance from both sites, by regula falsi with the Illinois
  /// modification on the difference of the squared distances.
  void solve()
  {
    double low = low_;
    double high = high_;
    double fLow = this->difference(low);
    double fHigh = this->difference(high);
    // Sites at equal distance at an end, to rounding: that end is the root.
    if (fLow >= 0.0 || fHigh <= 0.0)
    {
      root_ = fLow >= 0.0 ? low : high;
      this->difference(root_);
      return;
    }
    for (int i = 0; i < kMaxIterations && high - low > kTolerance; ++i)
    {
      root_ = (low * fHigh - high * fLow) / (fHigh - fLow);
      const double f = this->difference(root_);
      if (std::abs(f) < kTolerance)
      {
        break;
      }
      if (f < 0.0)
      {
        low = root_;
        fLow = f;
        fHigh *= 0.5;
      }
      else
      {
        high = root_;
        fHigh = f;
        fLow *= 0.5;
      }
    }
  }

  /// Narrows to the change from or to a third site that is nearer to the root. Returns false when
  /// there is none, that is when the root is final.
  bool narrow(const TileQuery& query)
  {
    const glm::dvec3& x = point_.position;
    const double distance = point_.radius();
    const SitePoint third = query.closest(x, distance);
    if (glm::distance(third.point, x) > distance - kSameDistance)
    {
      return false;
    }
    if (separationAngle(x, point_.a.point, third.point) >=
      separationAngle(x, third.point, point_.b.point))
    {
      high_ = root_;
      siteB_ = third.site;
    }
    else
    {
      low_ = root_;
      siteA_ = third.site;
    }
    return true;
  }

  const BisectorPoint& point() const { return point_; }

private:
  static constexpr int kMaxIterations = 60;
  static constexpr double kTolerance = 1e-9;

  double difference(double t)
  {
    point_.position = start_ + t * along_;
    point_.a = closestPoint(sites_, siteA_, point_.position);
    point_.b = closestPoint(sites_, siteB_, point_.position);
    const glm::dvec3 a = point_.a.point - point_.position;
    const glm::dvec3 b = point_.b.point - point_.position;
    return glm::dot(a, a) - glm::dot(b, b);
  }

  const SiteSet& sites_;
  glm::dvec3 start_;
  glm::dvec3 along_;
  int siteA_;
  int siteB_;
  double low_ = 0.0;
  double high_ = 1.0;
  double root_ = 0.5;
  BisectorPoint point_;
};

std::optional<BisectorPoint> atLeast(double angle, const BisectorPoint& point)
{
  return point.separationAngle() >= angle ? std::optional(point) : std::nullopt;
}

/// The point at equal distance from both sites, whatever else is as near up to the sag of facets.
/// Nothing where another site is nearer than that, or the separation angle is too small.
std::optional<BisectorPoint> facetedPoint(const AxisGeometry& geometry, const glm::dvec3& from,
  int fromSite, const glm::dvec3& to, int toSite)
{
  Change change(geometry.sites, from, fromSite, to, toSite);
  change.solve();
  BisectorPoint point = change.point();
  if (point.separationAngle() < geometry.angle)
  {
    return std::nullopt;
  }
  const double distance = point.radius();
  const SitePoint closest = geometry.query.closest(point.position, distance);
  if (glm::distance(closest.point, point.position) < distance - kFacets)
  {
    return std::nullopt;
  }
  const SitePoint other = point.a;
  point.a = closest;
  if (separationAngle(point.position, closest.point, other.point) > point.separationAngle())
  {
    point.b = other;
  }
  return atLeast(geometry.angle, point);
}

/// The same point with one of the sites' points as the second closest.
std::optional<BisectorPoint> widened(const AxisGeometry& geometry, BisectorPoint point,
  int fromSite, int toSite)
{
  const glm::dvec3& x = point.position;
  for (const int site : { fromSite, toSite })
  {
    const SitePoint other = closestPoint(geometry.sites, site, x);
    if (glm::distance(other.point, x) <= point.radius() + kFacets &&
      separationAngle(x, point.a.point, other.point) >= geometry.angle)
    {
      point.b = other;
      return point;
    }
  }
  return std::nullopt;
}

/// A point with the least separation angle between two points with different closest sites.
std::optional<BisectorPoint> axisBetween(const AxisGeometry& geometry, const glm::dvec3& from,
  int fromSite, const glm::dvec3& to, int toSite)
{
  const BisectorPoint exact = bisectorPoint(geometry, from, fromSite, to, toSite);
  if (exact.separationAngle() >= geometry.angle)
  {
    return exact;
  }
  std::optional<BisectorPoint> faceted = facetedPoint(geometry, from, fromSite, to, toSite);
  return faceted ? faceted : widened(geometry, exact, fromSite, toSite);
}

bool insideGrid(const AxisGeometry& geometry, const glm::dvec3& x)
{
  const glm::dvec3 index = (x - geometry.frame.first) / geometry.frame.step;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (index[axis] < geometry.extent.min[axis] || index[axis] > geometry.extent.max[axis])
    {
      return false;
    }
  }
  return true;
}

} // namespace

double BisectorPoint::separationAngle() const
{
  return medial::separationAngle(position, a.point, b.point);
}

glm::dvec3 BisectorPoint::normal() const
{
  const glm::dvec3 across = b.point - a.point;
  const double length = glm::length(across);
  return length > 0.0 ? across / length : glm::dvec3(0.0);
}

BisectorPoint bisectorPoint(const AxisGeometry& geometry, const glm::dvec3& from, int fromSite,
  const glm::dvec3& to, int toSite)
{
  Change change(geometry.sites, from, fromSite, to, toSite);
  change.solve();
  for (int round = 1; round < kMaxRounds && change.narrow(geometry.query); ++round)
  {
    change.solve();
  }
  return change.point();
}

std::optional<BisectorPoint> axisAlongNormal(const AxisGeometry& geometry, const BisectorPoint& x)
{
  const double radius = x.radius();
  if (radius < kLeastRadius)
  {
    return std::nullopt;
  }
  const glm::dvec3 away = (x.position - x.a.point) / radius;
  const double step = glm::dot(glm::abs(away), geometry.frame.step);
  const double reach = step * (0.5 / std::sin(0.5 * geometry.angle) + 0.5);
  const glm::dvec3 end = x.position + reach * away;
  if (!insideGrid(geometry, end))
  {
    return std::nullopt;
  }
  const SitePoint other = geometry.query.closest(end, radius + reach);
  if (separationAngle(end, end - away, other.point) < geometry.angle)
  {
    return std::nullopt;
  }
  return axisBetween(geometry, x.position, x.a.site, end, other.site);
}

BisectorPoints bisectorPoints(const AxisGeometry& geometry, bool exactAngle,
  std::vector<Crossing>& crossings)
{
  constexpr std::uint8_t kOnEdge = 0;
  constexpr std::uint8_t kMoved = 1;
  constexpr std::uint8_t kRemoved = 2;
  BisectorPoints result;
  result.points.resize(crossings.size());
  result.moved.resize(crossings.size());
  const double leastRadius = std::max(geometry.radius, kLeastRadius);
  tbb::parallel_for(std::size_t{ 0 }, crossings.size(),
    [&](std::size_t i)
    {
      geometry.checkpoint();
      const Crossing& crossing = crossings[i];
      const glm::dvec3 from = geometry.frame.sample(glm::dvec3(crossing.voxel));
      glm::dvec3 to = from;
      to[crossing.axis] += geometry.frame.step[crossing.axis];
      BisectorPoint& point = result.points[i];
      point = bisectorPoint(geometry, from, crossing.siteA, to, crossing.siteB);
      std::uint8_t fate = kOnEdge;
      if (exactAngle && point.separationAngle() < geometry.angle)
      {
        std::optional<BisectorPoint> other =
          facetedPoint(geometry, from, crossing.siteA, to, crossing.siteB);
        if (!other)
        {
          other = axisAlongNormal(geometry, point);
          fate = other ? kMoved : kRemoved;
        }
        point = other.value_or(point);
      }
      const bool large = point.radius() >= leastRadius && point.lambda() >= geometry.lambda;
      result.moved[i] = large ? fate : kRemoved;
    });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    if (result.moved[i] != kRemoved)
    {
      crossings[kept] = crossings[i];
      result.points[kept] = result.points[i];
      result.moved[kept] = result.moved[i];
      ++kept;
    }
  }
  crossings.resize(kept);
  result.points.resize(kept);
  result.moved.resize(kept);
  return result;
}

} // namespace medial

#include "medial/medial/bisector.h"

#include "medial/medial/separation.h"
#include "medial/sites/closest_point.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace medial
{
namespace
{

/// A nearer third site counts from this difference on, in frame units (voxels).
constexpr double kSameDistance = 1e-6;
/// Medial balls smaller than this (voxels) are the surface itself.
constexpr double kLeastRadius = 1e-3;
/// Sites between the two that are looked for at most.
constexpr int kMaxRounds = 8;

/// The part of a crossed edge that is known to hold a change from siteA to siteB.
struct Interval
{
  double low = 0.0;
  double high = 1.0;
  double root = 0.5;
};

class EdgeBisector
{
public:
  EdgeBisector(const SiteSet& sites, const GridFrame& frame, const Crossing& crossing)
    : sites_(sites)
    , crossing_(crossing)
    , start_(frame.sample(glm::dvec3(crossing.voxel)))
    , along_(0.0)
  {
    along_[crossing.axis] = frame.step[crossing.axis];
  }

  glm::dvec3 at(double t) const { return start_ + t * along_; }

  /// Root of dist^2(x(t), A) - dist^2(x(t), B) by regula falsi with the Illinois modification.
  double root(double low, double high) const
  {
    double fLow = this->difference(low);
    double fHigh = this->difference(high);
    // Sites at equal distance at an end, to rounding: that end is the root.
    if (fLow >= 0.0 || fHigh <= 0.0)
    {
      return fLow >= 0.0 ? low : high;
    }
    double t = 0.5 * (low + high);
    for (int i = 0; i < kMaxIterations && high - low > kTolerance; ++i)
    {
      t = (low * fHigh - high * fLow) / (fHigh - fLow);
      const double f = this->difference(t);
      if (std::abs(f) < kTolerance)
      {
        break;
      }
      if (f < 0.0)
      {
        low = t;
        fLow = f;
        fHigh *= 0.5;
      }
      else
      {
        high = t;
        fHigh = f;
        fLow *= 0.5;
      }
    }
    return t;
  }

private:
  static constexpr int kMaxIterations = 60;
  static constexpr double kTolerance = 1e-9;

  double difference(double t) const
  {
    const glm::dvec3 x = this->at(t);
    const glm::dvec3 a = closestPoint(sites_, crossing_.siteA, x).point - x;
    const glm::dvec3 b = closestPoint(sites_, crossing_.siteB, x).point - x;
    return glm::dot(a, a) - glm::dot(b, b);
  }

  const SiteSet& sites_;
  const Crossing& crossing_;
  glm::dvec3 start_;
  glm::dvec3 along_;
};

/// Narrows a crossing to the change from or to a third site that is nearer to x, the point at the
/// root. Returns false when there is none, that is when the root is final.
bool narrow(const SiteSet& sites, const TileQuery& query, const glm::dvec3& x, Crossing& crossing,
  Interval& interval)
{
  const SitePoint a = closestPoint(sites, crossing.siteA, x);
  const SitePoint b = closestPoint(sites, crossing.siteB, x);
  const double distance = glm::distance(a.point, x);
  const SitePoint third = query.closest(x, distance);
  if (glm::distance(third.point, x) > distance - kSameDistance)
  {
    return false;
  }
  if (separationAngle(x, a.point, third.point) >= separationAngle(x, third.point, b.point))
  {
    interval.high = interval.root;
    crossing.siteB = third.site;
  }
  else
  {
    interval.low = interval.root;
    crossing.siteA = third.site;
  }
  return true;
}

void removeSurfacePoints(const SiteSet& sites, std::vector<Crossing>& crossings,
  std::vector<glm::dvec3>& points)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const SitePoint closest = closestPoint(sites, crossings[i].siteA, points[i]);
    if (glm::distance(closest.point, points[i]) >= kLeastRadius)
    {
      crossings[kept] = crossings[i];
      points[kept] = points[i];
      ++kept;
    }
  }
  crossings.resize(kept);
  points.resize(kept);
}

} // namespace

std::vector<glm::dvec3> bisectorPoints(const SiteSet& sites, const GridFrame& frame,
  const TileQuery& query, std::vector<Crossing>& crossings)
{
  std::vector<glm::dvec3> points(crossings.size());
  tbb::parallel_for(std::size_t{ 0 }, crossings.size(),
    [&](std::size_t i)
    {
      Interval interval;
      for (int round = 0; round < kMaxRounds; ++round)
      {
        const EdgeBisector bisector(sites, frame, crossings[i]);
        interval.root = bisector.root(interval.low, interval.high);
        points[i] = bisector.at(interval.root);
        if (!narrow(sites, query, points[i], crossings[i], interval))
        {
          break;
        }
      }
    });
  removeSurfacePoints(sites, crossings, points);
  return points;
}

} // namespace medial

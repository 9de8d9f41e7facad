#include "medial/medial/bisector.h"

#include "medial/culling/closest_site_query.h"
#include "medial/medial/separation.h"
#include "medial/sites/closest_point.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numeric>

namespace medial
{
namespace
{

/// A nearer third site counts from this difference on, in frame units (voxels).
constexpr double kSameDistance = 1e-6;
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

/// Narrows a crossing to the change from or to a third site. Returns false when `third` is no
/// nearer than the two, that is when the root is final.
bool narrow(const SiteSet& sites, const SitePoint& third, const glm::dvec3& x, Crossing& crossing,
  Interval& interval)
{
  const SitePoint a = closestPoint(sites, crossing.siteA, x);
  const SitePoint b = closestPoint(sites, crossing.siteB, x);
  if (glm::distance(third.point, x) > glm::distance(a.point, x) - kSameDistance)
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

} // namespace

std::vector<glm::dvec3> bisectorPoints(const SiteSet& sites, const CandidateFilter& filter,
  const GridFrame& frame, std::vector<Crossing>& crossings)
{
  std::vector<Interval> intervals(crossings.size());
  std::vector<glm::dvec3> points(crossings.size());
  std::vector<std::size_t> open(crossings.size());
  std::iota(open.begin(), open.end(), std::size_t{ 0 });
  for (int round = 0; round < kMaxRounds && !open.empty(); ++round)
  {
    std::vector<glm::dvec3> queries(open.size());
    tbb::parallel_for(std::size_t{ 0 }, open.size(),
      [&](std::size_t i)
      {
        const std::size_t c = open[i];
        const EdgeBisector bisector(sites, frame, crossings[c]);
        intervals[c].root = bisector.root(intervals[c].low, intervals[c].high);
        points[c] = queries[i] = bisector.at(intervals[c].root);
      });
    const std::vector<SitePoint> closest = closestSites(sites, filter, queries);
    std::vector<std::size_t> narrowed;
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      const std::size_t c = open[i];
      if (narrow(sites, closest[i], points[c], crossings[c], intervals[c]))
      {
        narrowed.push_back(c);
      }
    }
    open = std::move(narrowed);
  }
  return points;
}

} // namespace medial

#include "axis/site_change.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// A third site counts as nearer from this difference on, in local units (voxels).
constexpr double kSameDistance = 1e-6;

/// Returns the root of the quadratic on [0, 1] with f(0) = atZero < 0, f'(0) = slope and f(1) =
/// atOne > 0.
double rootOfQuadratic(double atZero, double slope, double atOne)
{
  const double square = atOne - atZero - slope;
  const double discriminant = std::max(0.0, slope * slope - 4.0 * square * atZero);
  const double denominator = slope + std::sqrt(discriminant);
  return denominator > 0.0 ? std::min(1.0, -2.0 * atZero / denominator) : 0.5;
}

} // namespace

SiteChange::SiteChange(const SiteSet& sites, const SiteSegment& segment)
  : sites_(&sites)
  , start_(segment.from)
  , along_(segment.to - segment.from)
  , siteA_(segment.fromSite)
  , siteB_(segment.toSite)
{
  this->solve();
}

bool SiteChange::found() const
{
  const double toB = glm::distance(point_.position, point_.b.point);
  return std::abs(toB - point_.radius()) < kSameDistance;
}

bool SiteChange::settledBy(const SitePoint& closest) const
{
  return glm::distance(closest.point, point_.position) > point_.radius() - kSameDistance;
}

void SiteChange::narrow(const SitePoint& third)
{
  const glm::dvec3& x = point_.position;
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
  this->solve();
}

/// Squared distances, and their difference, are quadratic along the segment as long as the closest
/// points stay on the same faces, edges and vertices. So usually the first step ends at the root.
void SiteChange::solve()
{
  constexpr int kMaxIterations = 60;
  constexpr double kTolerance = 1e-9;
  End low = this->evaluate(low_);
  End high = this->evaluate(high_);
  // If the sites are at equal distance at an end, up to rounding, that end is the root.
  if (low.value >= 0.0 || high.value <= 0.0)
  {
    root_ = low.value >= 0.0 ? low_ : high_;
    this->evaluate(root_);
    return;
  }
  double part = rootOfQuadratic(low.value, low.gradient * (high.t - low.t), high.value);
  for (int i = 0; i < kMaxIterations && high.t - low.t > kTolerance; ++i)
  {
    const double length = high.t - low.t;
    root_ = low.t + part * length;
    const End middle = this->evaluate(root_);
    if (std::abs(middle.value) < kTolerance)
    {
      break;
    }
    (middle.value < 0.0 ? low : high) = middle;
    const bool halved = high.t - low.t <= 0.5 * length;
    part = halved ? rootOfQuadratic(low.value, low.gradient * (high.t - low.t), high.value) : 0.5;
  }
}

SiteChange::End SiteChange::evaluate(double t)
{
  point_.position = start_ + t * along_;
  point_.a = closestPoint(*sites_, siteA_, point_.position);
  point_.b = closestPoint(*sites_, siteB_, point_.position);
  const glm::dvec3 a = point_.a.point - point_.position;
  const glm::dvec3 b = point_.b.point - point_.position;
  return { t, glm::dot(a, a) - glm::dot(b, b), 2.0 * glm::dot(along_, b - a) };
}

} // namespace medial

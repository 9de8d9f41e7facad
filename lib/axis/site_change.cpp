#include "axis/site_change.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

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
  , low_(this->evaluate(0.0))
  , high_(this->evaluate(1.0))
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
    siteB_ = third.site;
    high_ = this->endAt(root_, point_.a, third);
    low_ = this->endAt(low_.t, low_.a, closestPoint(*sites_, siteB_, this->at(low_.t)));
  }
  else
  {
    siteA_ = third.site;
    low_ = this->endAt(root_, third, point_.b);
    high_ = this->endAt(high_.t, closestPoint(*sites_, siteA_, this->at(high_.t)), high_.b);
  }
  this->solve();
}

/// Squared distances, and their difference, are quadratic along the segment as long as the closest
/// points stay on the same faces, edges and vertices. So usually the first step ends at the root.
void SiteChange::solve()
{
  constexpr int kMaxIterations = 60;
  constexpr double kTolerance = 1e-9;
  End low = low_;
  End high = high_;
  // If the sites are at equal distance at an end, up to rounding, that end is the root.
  End root = low.value >= 0.0 ? low : high;
  if (low.value < 0.0 && high.value > 0.0)
  {
    double part = rootOfQuadratic(low.value, low.gradient * (high.t - low.t), high.value);
    for (int i = 0; i < kMaxIterations && high.t - low.t > kTolerance; ++i)
    {
      const double length = high.t - low.t;
      root = this->evaluate(low.t + part * length);
      if (std::abs(root.value) < kTolerance)
      {
        break;
      }
      (root.value < 0.0 ? low : high) = root;
      const bool halved = high.t - low.t <= 0.5 * length;
      part = halved ? rootOfQuadratic(low.value, low.gradient * (high.t - low.t), high.value) : 0.5;
    }
  }
  root_ = root.t;
  point_ = { this->at(root.t), root.a, root.b };
}

SiteChange::End SiteChange::evaluate(double t) const
{
  const glm::dvec3 x = this->at(t);
  return this->endAt(t, closestPoint(*sites_, siteA_, x), closestPoint(*sites_, siteB_, x));
}

SiteChange::End SiteChange::endAt(double t, const SitePoint& a, const SitePoint& b) const
{
  const glm::dvec3 x = this->at(t);
  const glm::dvec3 toA = a.point - x;
  const glm::dvec3 toB = b.point - x;
  return { t, a, b, glm::dot(toA, toA) - glm::dot(toB, toB), 2.0 * glm::dot(along_, toB - toA) };
}

} // namespace medial

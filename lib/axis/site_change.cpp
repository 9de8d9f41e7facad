#include "axis/site_change.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Squared distances that differ by less, in local units (voxels), are equal.
constexpr double kTolerance = 1e-9;

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

double guessedChange(const SiteSegment& segment, const SitePoint& a, const SitePoint& b)
{
  const glm::dvec3 along = segment.to - segment.from;
  const glm::dvec3 toA = a.point - segment.from;
  const glm::dvec3 toB = b.point - segment.to;
  const double lengthA = glm::length(toA);
  const double lengthB = glm::length(toB);
  const double shrinkA = glm::dot(along, toA) / lengthA;
  const double shrinkB = glm::dot(along, toB) / lengthB;
  const double t = (lengthA - lengthB - shrinkB) / (shrinkA - shrinkB);
  return t > 0.0 ? std::min(t, 1.0) : 0.0;
}

SiteChange::SiteChange(const SiteSet& sites, const SiteSegment& segment)
  : sites_(&sites)
  , start_(segment.from)
  , along_(segment.to - segment.from)
  , siteA_(segment.fromSite)
  , siteB_(segment.toSite)
{
  const double guess = segment.change >= 0.0
    ? segment.change
    : guessedChange(segment, closestPoint(sites, siteA_, segment.from),
        closestPoint(sites, siteB_, segment.to));
  if (!this->solveFrom(guess))
  {
    this->findEnds();
    this->solve();
  }
}

bool SiteChange::found() const
{
  const double toB = glm::distance(point_.position, point_.b.point);
  return std::abs(toB - point_.radius()) < kSameDistance;
}

void SiteChange::narrow(const SitePoint& third)
{
  const glm::dvec3& x = point_.position;
  const bool toThird = separationAngle(x, point_.a.point, third.point) >=
    separationAngle(x, third.point, point_.b.point);
  (toThird ? siteB_ : siteA_) = third.site;
  if (!endsKnown_)
  {
    this->findEnds();
  }
  if (toThird)
  {
    high_ = this->placeAt(root_, point_.a, third);
    low_ = this->placeAt(low_.t, low_.a, closestPoint(*sites_, siteB_, this->at(low_.t)));
  }
  else
  {
    low_ = this->placeAt(root_, third, point_.b);
    high_ = this->placeAt(high_.t, closestPoint(*sites_, siteA_, this->at(high_.t)), high_.b);
  }
  this->solve();
}

void SiteChange::findEnds()
{
  low_ = this->evaluate(0.0);
  high_ = this->evaluate(1.0);
  endsKnown_ = true;
}

/// Squared distances, and their difference, are quadratic along the segment as long as the closest
/// points stay on the same faces, edges and vertices. So a step or two end at the root, mostly.
/// Returns whether they do.
bool SiteChange::solveFrom(double t)
{
  constexpr int kMaxSteps = 4;
  for (int i = 0; i < kMaxSteps && t >= 0.0 && t <= 1.0; ++i)
  {
    const Place place = this->evaluate(t);
    if (std::abs(place.value) < kTolerance)
    {
      this->setRoot(place);
      return true;
    }
    t += this->stepToRoot(place);
  }
  return false;
}

/// Finds the root between the ends.
void SiteChange::solve()
{
  constexpr int kMaxIterations = 60;
  Place low = low_;
  Place high = high_;
  // If the sites are at equal distance at an end, up to rounding, that end is the root.
  Place root = low.value >= 0.0 ? low : high;
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
  this->setRoot(root);
}

void SiteChange::setRoot(const Place& root)
{
  root_ = root.t;
  point_ = { this->at(root.t), root.a, root.b };
}

SiteChange::Place SiteChange::evaluate(double t) const
{
  const glm::dvec3 x = this->at(t);
  return this->placeAt(t, closestPoint(*sites_, siteA_, x), closestPoint(*sites_, siteB_, x));
}

SiteChange::Place SiteChange::placeAt(double t, const SitePoint& a, const SitePoint& b) const
{
  const glm::dvec3 x = this->at(t);
  const glm::dvec3 toA = a.point - x;
  const glm::dvec3 toB = b.point - x;
  return { t, a, b, glm::dot(toA, toA) - glm::dot(toB, toB), 2.0 * glm::dot(along_, toB - toA) };
}

/// Returns the factor of the square of t in the squared distance from a face, edge or vertex.
double SiteChange::curvature(const SitePoint& closest, double t) const
{
  const double whole = glm::dot(along_, along_);
  const glm::dvec3 way = closest.point - this->at(t);
  switch (sites_->kind(closest.site))
  {
    case SiteKind::Face:
    {
      const double across = glm::dot(along_, way);
      return across * across / glm::dot(way, way);
    }
    case SiteKind::Edge:
    {
      const glm::ivec2& ends = sites_->edges()[closest.site - sites_->firstEdge()];
      const glm::dvec3 edge = sites_->points()[ends[1]] - sites_->points()[ends[0]];
      const double beside = glm::dot(along_, edge);
      return whole - beside * beside / glm::dot(edge, edge);
    }
    case SiteKind::Vertex:
      break;
  }
  return whole;
}

/// Returns the way to the nearer root of the quadratic through a place; not a number if there is
/// none.
double SiteChange::stepToRoot(const Place& place) const
{
  const double square = this->curvature(place.a, place.t) - this->curvature(place.b, place.t);
  const double root = std::sqrt(place.gradient * place.gradient - 4.0 * square * place.value);
  return -2.0 * place.value / (place.gradient + std::copysign(root, place.gradient));
}

} // namespace medial

#include "thickness/ball_ascent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// By how much balls should hold the point, voxels: by more than they are found to, so that those
/// that are found do hold it.
constexpr double kWithin = 0.003;
constexpr double kPrecision = 0.002;
constexpr int kMaxSteps = 6;
constexpr int kMaxCuts = 30;
constexpr int kMaxPivots = 40;
constexpr double kTiny = 1e-12;
/// By how much a ball should be larger than the one that is known, voxels.
constexpr double kGain = 0.04;
/// How far from the way inwards the centres of larger balls may be, voxels, to be found for sure.
constexpr double kAcross = 0.5;
/// Number of surface points that are kept for the next point.
constexpr std::size_t kKnown = 8;
/// By how much an optimum may violate a half-space, in squares of the radius.
constexpr double kViolation = 1e-10;

/// Numbers of half-spaces: two for each of three directions, and that of the point.
constexpr std::size_t kOfPoint = 6;
constexpr std::size_t kOwnBounds = 7;

} // namespace

BallAscent::BallAscent(const SiteQuery& query, const GridFrame& frame)
  : query_(query)
  , low_(frame.first)
  , high_(-frame.first)
{
}

/// Measures the ball around a place relative to the point. Returns its radius.
double BallAscent::look(const glm::dvec3& offset)
{
  const glm::dvec3 place = point_ + offset;
  closest_ = query_.closest(place, closest_);
  found_.push_back(closest_.point);
  this->addBound(closest_.point);
  const double radius = glm::distance(place, closest_.point);
  if (radius > best_.radius && glm::length(offset) <= radius &&
    glm::all(glm::greaterThanEqual(place, low_)) && glm::all(glm::lessThanEqual(place, high_)))
  {
    best_ = { offset, radius };
  }
  return radius;
}

void BallAscent::addBound(const glm::dvec3& surfacePoint)
{
  const glm::dvec3 q = surfacePoint - point_;
  bounds_.push_back({ Vector(2.0 * q, 1.0), glm::dot(q, q) });
}

std::optional<BallAscent::Ball> BallAscent::largerBallAround(const glm::dvec3& point, double known)
{
  point_ = point;
  best_ = { glm::dvec3(0.0), 0.0 };
  bounds_.resize(kOwnBounds);
  const double depth = this->look(glm::dvec3(0.0));
  if (!(depth > kWithin))
  {
    return std::nullopt;
  }
  for (std::size_t k = found_.size() - 1; k-- > 0;)
  {
    this->addBound(found_[k]);
  }
  const glm::dvec3 inwards = (point - closest_.point) / depth;
  from_ = std::max(known - depth, depth) * inwards;
  const double wanted = std::max(known, depth) + kGain;
  // The first linearisation may be far from all balls, and far below their squared radii.
  double limit = wanted * wanted - kAcross * kAcross;
  for (int step = 0; step < kMaxSteps; ++step)
  {
    const double before = best_.radius;
    if (!this->climb(inwards, depth, limit) || (step > 0 && best_.radius <= before + kPrecision))
    {
      break;
    }
    from_ = best_.centre;
    limit = best_.radius * best_.radius;
  }
  if (found_.size() > kKnown)
  {
    found_.erase(found_.begin(), found_.end() - kKnown);
  }
  return best_.radius > std::max(known, depth)
    ? std::optional(Ball{ point + best_.centre, best_.radius })
    : std::nullopt;
}

/// Looks for larger balls with a larger linearisation.
/// @param limit of the linearisation, squares of voxels. Less is of no use.
/// @return false if no more than the limit was to be had.
bool BallAscent::climb(const glm::dvec3& inwards, double depth, double limit)
{
  objective_ = Vector(2.0 * from_, 1.0);
  this->setBounds(inwards, depth);
  for (int cut = 0; cut < kMaxCuts && this->optimise(); ++cut)
  {
    const glm::dvec3 offset(optimum_);
    if (glm::dot(objective_, optimum_) - glm::dot(from_, from_) <= limit)
    {
      return false;
    }
    const double wanted = std::sqrt(std::max(0.0, optimum_.w + glm::dot(offset, offset)));
    if (this->look(offset) >= wanted - kPrecision)
    {
      break;
    }
  }
  return true;
}

/// Sets the half-spaces that are no surface points: a box around the place of the linearisation,
/// about as large as the Voronoi region is there, and the one of the point. Sets the basis to the
/// optimum over these and the point closest to the point.
void BallAscent::setBounds(const glm::dvec3& inwards, double depth)
{
  const double radius = glm::dot(from_, inwards) + depth;
  const double across = 1.5 * std::sqrt(2.0 * depth * std::max(radius, depth)) + depth;
  const double along = std::max(radius, depth) + depth;
  const glm::dvec3 other =
    std::abs(inwards.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(inwards, other));
  const std::array<glm::dvec3, 3> axes{ inwards, u, glm::cross(inwards, u) };
  const glm::dvec3 slope = glm::dvec3(objective_) - glm::dvec3(bounds_[kOwnBounds].a);
  for (std::size_t k = 0; k < axes.size(); ++k)
  {
    const double middle = glm::dot(axes[k], from_);
    const double half = k == 0 ? along : across;
    bounds_[2 * k] = { Vector(axes[k], 0.0), middle + half };
    bounds_[2 * k + 1] = { Vector(-axes[k], 0.0), half - middle };
    basis_[k] = glm::dot(slope, axes[k]) >= 0.0 ? 2 * k : 2 * k + 1;
  }
  basis_.back() = kOwnBounds;
  bounds_[kOfPoint] = { Vector(0.0, 0.0, 0.0, -1.0), -2.0 * kWithin * radius };
  glm::dmat4 normals;
  Vector right;
  for (int k = 0; k < 4; ++k)
  {
    normals[k] = bounds_[basis_[k]].a;
    right[k] = bounds_[basis_[k]].b;
  }
  rays_ = glm::inverse(glm::transpose(normals));
  optimum_ = rays_ * right;
}

std::optional<std::size_t> BallAscent::mostViolated() const
{
  std::optional<std::size_t> most;
  double violation = kViolation * (1.0 + glm::dot(from_, from_));
  for (std::size_t h = 0; h < bounds_.size(); ++h)
  {
    const double beyond = glm::dot(bounds_[h].a, optimum_) - bounds_[h].b;
    if (beyond > violation)
    {
      violation = beyond;
      most = h;
    }
  }
  return most;
}

/// Finds the optimum over all half-spaces by the dual simplex method: the basis stays optimal over
/// itself, and a violated half-space replaces one of it. Returns whether there is one.
bool BallAscent::optimise()
{
  for (int pivot = 0; pivot < kMaxPivots; ++pivot)
  {
    const std::optional<std::size_t> entering = this->mostViolated();
    if (!entering)
    {
      return true;
    }
    const HalfSpace& bound = bounds_[*entering];
    const Vector weights = objective_ * rays_;
    const Vector change = bound.a * rays_;
    int leaving = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 4; ++k)
    {
      if (change[k] > kTiny && std::max(weights[k], 0.0) < least * change[k])
      {
        least = std::max(weights[k], 0.0) / change[k];
        leaving = k;
      }
    }
    if (leaving < 0)
    {
      return false;
    }
    const Vector ray = rays_[leaving] / change[leaving];
    for (int k = 0; k < 4; ++k)
    {
      rays_[k] = k == leaving ? ray : rays_[k] - change[k] * ray;
    }
    optimum_ += (bound.b - glm::dot(bound.a, optimum_)) * ray;
    basis_[leaving] = *entering;
  }
  return false;
}

} // namespace medial

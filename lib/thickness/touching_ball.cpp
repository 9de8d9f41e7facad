#include "thickness/touching_ball.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Distances that differ by less than this share count as equal.
constexpr double kSameDistance = 1e-9;
/// Positions that differ by less than this share count as equal.
constexpr double kSamePosition = 1e-10;
/// Share of the diagonal at which the search for very small balls ends.
constexpr double kMinStart = 1e-9;
/// From this ratio of their ends on, intervals are halved by ratio, not where tangents meet.
constexpr double kLongInterval = 16.0;
/// Number of parts of an interval for which bounds are computed.
constexpr int kBoundParts = 16;
/// A wide place between narrow ones is certain to be found if its angle exceeds the separation
/// angle by this many degrees.
constexpr double kMargin = 0.02;
/// Maximum number of intervals of one ray that are searched; a handful is usual. The second number
/// is the limit after which narrow ends must do, without proof for the space in between.
constexpr int kMaxIntervals = 6000;
constexpr int kMaxProofs = 5000;

double distanceAt(const glm::dvec3& direction, double t, const glm::dvec3& point)
{
  return glm::length(point - t * direction);
}

} // namespace

TouchingBall::TouchingBall(SurfaceAnswers& surface, double angle, double diagonal)
  : surface_(surface)
  , cosine_(std::cos(glm::radians(angle)))
  , certain_(std::cos(glm::radians(std::min(angle + kMargin, 180.0))))
  // If a point at distance c <= diagonal from the start is seen at `angle` from x(t) and is nearer
  // than the start, then t <= c / sin(angle).
  , reach_(1.01 * diagonal / std::sin(glm::radians(std::min(angle, 90.0))))
  , diagonal_(diagonal)
{
}

double TouchingBall::minStart() const
{
  return kMinStart * diagonal_;
}

bool TouchingBall::isWide(const Ray& ray, double t, const Sample& sample, double distance) const
{
  return t - sample.height <= cosine_ * distance && distance >= ray.minCloseness * t;
}

bool TouchingBall::isCertainlyWide(double t, double height, double distance) const
{
  return t - height <= certain_ * distance;
}

TouchingBall::Sample TouchingBall::sampleOf(const Ray& ray, double t, const SitePoint& found) const
{
  Sample sample;
  sample.t = t;
  sample.site = found.site;
  sample.point = found.point - ray.start;
  sample.height = glm::dot(sample.point, ray.direction);
  sample.square = glm::dot(sample.point, sample.point);
  sample.distance = distanceAt(ray.direction, t, sample.point);
  sample.wide = this->isWide(ray, t, sample, sample.distance);
  return sample;
}

bool TouchingBall::isStart(const Sample& sample) const
{
  return sample.distance >= (1.0 - kSameDistance) * sample.t;
}

TouchingBall::Ball TouchingBall::ballOf(const Ray& ray, const Sample& sample)
{
  return { sample.distance, sample.t, ray.start + sample.point, sample.distance / sample.t };
}

TouchingBall::Sample TouchingBall::look(const Ray& ray, double t) const
{
  // The start itself is on the surface, up to rounding.
  const double limit = t * (1.0 + kSameDistance) + kSameDistance * this->minStart();
  const SitePoint found = surface_.closest(ray.start + t * ray.direction, limit);
  return this->sampleOf(ray, t, found.site >= 0 ? found : SitePoint{ -1, ray.start });
}

std::optional<TouchingBall::Sample> TouchingBall::lookNearer(const Ray& ray, double t,
  double distance) const
{
  const SitePoint found =
    surface_.closest(ray.start + t * ray.direction, distance * (1.0 - kSameDistance));
  return found.site >= 0 ? std::optional(this->sampleOf(ray, t, found)) : std::nullopt;
}

/// Returns where the tangents at the ends of an interval meet.
template <typename Interval>
static double meeting(const Interval& interval)
{
  const auto& [low, high] = interval;
  const double t = 0.5 * (high.square - low.square) / (high.height - low.height);
  // Rounding may place the meeting just outside the interval, where an earlier look hit the centre.
  if (t > high.t && t <= high.t * (1.0 + kSamePosition))
  {
    return high.t;
  }
  if (t < low.t && t >= low.t * (1.0 - kSamePosition))
  {
    return low.t;
  }
  // If they are parallel up to rounding, the tangents are one, and any position will do.
  return t >= low.t && t <= high.t ? t : 0.5 * (low.t + high.t);
}

/// Returns a lower bound of the distance between two positions of an interval: a concave function
/// is not below its chord.
template <typename Interval>
static double chordDistance(const Interval& interval, double begin, double end)
{
  const auto& [low, high] = interval;
  const double atLow = low.square - 2.0 * low.t * low.height;
  const double atHigh = high.square - 2.0 * high.t * high.height;
  const double slope = (atHigh - atLow) / (high.t - low.t);
  const double min = std::clamp(-0.5 * slope, begin, end);
  const double square = atLow + slope * (min - low.t) + min * min;
  return std::sqrt(std::max(square, 0.0));
}

/// Whether nothing can be wide inside an interval with narrow ends. A position is wide if
///   t <= height + cosine * distance.
/// Beyond the place where the tangents meet, the point of the upper end bounds both terms, and t
/// grows faster than cosine * distance. Before it, the point of the lower end bounds the distance
/// in the same way. The height is minus half the slope of a concave function and grows; the slope
/// from the lower tangent at t to the upper end bounds it.
bool TouchingBall::staysNarrow(const Ray& ray, const Interval& interval) const
{
  const auto& [low, high] = interval;
  const double middle = meeting(interval);
  if (this->isCertainlyWide(middle, high.height, distanceAt(ray.direction, middle, high.point)))
  {
    return false;
  }
  const double atHigh = high.square - 2.0 * high.t * high.height;
  const double growth = std::pow(middle / low.t, 1.0 / kBoundParts);
  double begin = low.t;
  for (int part = 0; part < kBoundParts; ++part)
  {
    const double end = part + 1 < kBoundParts ? begin * growth : middle;
    const double tangent = low.square - 2.0 * end * low.height;
    const double height =
      high.t > end ? std::min(high.height, 0.5 * (tangent - atHigh) / (high.t - end)) : high.height;
    // Above 90 degrees the cosine is negative, so a lower bound is needed.
    const double distance = certain_ > 0.0 ? distanceAt(ray.direction, begin, low.point)
                                           : chordDistance(interval, begin, end);
    if (this->isCertainlyWide(begin, height, distance))
    {
      return false;
    }
    begin = end;
  }
  return true;
}

/// The distance is at most that from the closest point of either end, x being p at t:
///   |p - x(t)|^2 = square - 2 t height + t^2.
/// It is less than closeness * t between two roots. If those of the ends overlap, it is everywhere.
bool TouchingBall::isFar(const Ray& ray, const Interval& interval)
{
  const auto& [low, high] = interval;
  const double share = 1.0 - ray.minCloseness * ray.minCloseness;
  if (ray.minCloseness <= 0.0 || share <= 0.0 || low.distance >= ray.minCloseness * low.t ||
    high.distance >= ray.minCloseness * high.t)
  {
    return false;
  }
  const auto root = [share](const Sample& end, double sign)
  {
    const double discriminant = end.height * end.height - share * end.square;
    return (end.height + sign * std::sqrt(std::max(discriminant, 0.0))) / share;
  };
  return root(low, 1.0) >= root(high, -1.0);
}

/// Looks inside an interval. Returns the ball if that settles the search; otherwise adds the
/// remaining parts of the interval, the lowest last.
std::optional<TouchingBall::Ball> TouchingBall::split(const Ray& ray, const Interval& interval,
  std::vector<Interval>& pending) const
{
  const auto& [low, high] = interval;
  if (!high.wide && high.t > kLongInterval * low.t)
  {
    const Sample middle = this->look(ray, std::sqrt(low.t * high.t));
    if (middle.wide)
    {
      pending.clear();
    }
    else
    {
      pending.push_back({ middle, high });
    }
    pending.push_back({ low, middle });
    return std::nullopt;
  }
  const double t = meeting(interval);
  const double distance =
    std::min(distanceAt(ray.direction, t, low.point), distanceAt(ray.direction, t, high.point));
  const std::optional<Sample> nearer = this->lookNearer(ray, t, distance);
  if (!nearer)
  {
    // No other points are closest inside the interval.
    if (high.wide || this->isWide(ray, t, high, distance))
    {
      return Ball{ distance, t, ray.start + high.point, distance / t };
    }
    return std::nullopt;
  }
  if (nearer->wide)
  {
    pending.clear();
  }
  else
  {
    pending.push_back({ *nearer, high });
  }
  pending.push_back({ low, *nearer });
  return std::nullopt;
}

std::optional<TouchingBall::Ball> TouchingBall::search(const Ray& ray, const Sample& low,
  double guess) const
{
  if (guess <= low.t || guess >= reach_)
  {
    return this->firstWide(ray, low, this->look(ray, reach_));
  }
  const Sample middle = this->look(ray, guess);
  const std::optional<Ball> ball = this->firstWide(ray, low, middle);
  return ball || middle.wide ? ball : this->firstWide(ray, middle, this->look(ray, reach_));
}

std::optional<TouchingBall::Ball> TouchingBall::findBehind(const Ray& ray, const Ball& narrower,
  double end) const
{
  const double height = glm::dot(narrower.opposite - ray.start, ray.direction);
  if (narrower.position - height <= cosine_ * narrower.radius &&
    narrower.closeness >= ray.minCloseness)
  {
    return narrower;
  }
  const Sample low = this->look(ray, narrower.position);
  std::optional<Ball> ball =
    low.wide ? std::optional(ballOf(ray, low)) : this->firstWide(ray, low, this->look(ray, end));
  if (ball)
  {
    ball->startCloseness = narrower.startCloseness;
  }
  return ball;
}

std::optional<TouchingBall::Ball> TouchingBall::findBeyond(const Ray& ray, const Ball& ball,
  double end) const
{
  constexpr double kBeyond = 4.0;
  const double position = kBeyond * std::max(ball.position, this->minStart());
  if (position >= end)
  {
    return std::nullopt;
  }
  const Sample low = this->look(ray, position);
  std::optional<Ball> next =
    low.wide ? std::optional(ballOf(ray, low)) : this->firstWide(ray, low, this->look(ray, end));
  if (next)
  {
    next->startCloseness = 1.0; // the edge may be nearer than the start, but means nothing
  }
  return next;
}

std::optional<TouchingBall::Ball> TouchingBall::firstWide(const Ray& ray, const Sample& low,
  const Sample& high) const
{
  std::vector<Interval> pending{ { low, high } };
  for (int count = 0; count < kMaxIntervals && !pending.empty(); ++count)
  {
    const Interval interval = pending.back();
    pending.pop_back();
    const bool point = interval.high.t - interval.low.t <= kSamePosition * interval.high.t;
    if (point && interval.high.wide)
    {
      return ballOf(ray, interval.high);
    }
    const bool narrow = isFar(ray, interval) ||
      (!interval.high.wide && (point || count > kMaxProofs || this->staysNarrow(ray, interval)));
    if (narrow)
    {
      continue;
    }
    if (const std::optional<Ball> ball = this->split(ray, interval, pending))
    {
      return ball;
    }
  }
  // This happens only if rounding hides the end: then the nearest known wide place counts.
  return pending.empty() || !pending.front().high.wide
    ? std::nullopt
    : std::optional(ballOf(ray, pending.front().high));
}

} // namespace medial

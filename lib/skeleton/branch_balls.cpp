#include "skeleton/branch_balls.h"

#include "base/sorted_set.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

/// Balls are this part of their radius apart. Their union is smaller by 0.2 % than that of all.
constexpr double kSpacing = 0.125;
constexpr std::size_t kGroup = 16;
/// Balls that tell how wide a branch is have this part of the radius of the largest one at least.
constexpr double kLarge = 0.1;
/// Up to this many radii half the width is that of a limb.
constexpr double kRound = 1.1;

} // namespace

BranchBalls::BallsOfBranch::BallsOfBranch(std::vector<Ball> all)
  : balls(std::move(all))
{
  for (std::size_t begin = 0; begin < balls.size(); begin += kGroup)
  {
    const std::size_t end = std::min(begin + kGroup, balls.size());
    Group group{ { balls[(begin + end) / 2].centre, 0.0 }, begin, end };
    for (std::size_t i = begin; i < end; ++i)
    {
      group.around.radius = std::max(group.around.radius,
        glm::distance(group.around.centre, balls[i].centre) + balls[i].radius);
    }
    groups.push_back(group);
  }
}

void BranchBalls::set(std::size_t branch, const Curve& curve)
{
  branches_.resize(std::max(branches_.size(), branch + 1));
  std::vector<Ball> balls;
  const std::vector<double> radii = curve.radii.empty() ? probe_.radii(curve.points) : curve.radii;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    const Ball ball{ curve.points[i], radii[i] };
    if (balls.empty() || i + 1 == radii.size() ||
      glm::distance(balls.back().centre, ball.centre) >=
        kSpacing * std::min(balls.back().radius, ball.radius))
    {
      balls.push_back(ball);
    }
  }
  branches_[branch] = BallsOfBranch(std::move(balls));
}

void BranchBalls::reverse(std::size_t branch)
{
  std::vector<Ball> balls = std::move(branches_[branch].balls);
  std::reverse(balls.begin(), balls.end());
  branches_[branch] = BallsOfBranch(std::move(balls));
}

void BranchBalls::join(std::size_t branch, std::size_t other)
{
  std::vector<Ball> balls = std::move(branches_[branch].balls);
  balls.insert(balls.end(), branches_[other].balls.begin(), branches_[other].balls.end());
  branches_[branch] = BallsOfBranch(std::move(balls));
  branches_[other] = BallsOfBranch();
}

BranchBalls::Outside BranchBalls::outside(const glm::dvec3& x, std::size_t except) const
{
  Outside result{ std::numeric_limits<double>::infinity(), except, x };
  for (std::size_t b = 0; b < branches_.size(); ++b)
  {
    if (b == except)
    {
      continue;
    }
    for (const Group& group : branches_[b].groups)
    {
      if (glm::distance(x, group.around.centre) - group.around.radius >= result.distance)
      {
        continue;
      }
      for (std::size_t i = group.begin; i < group.end; ++i)
      {
        const Ball& ball = branches_[b].balls[i];
        const double distance = glm::distance(x, ball.centre) - ball.radius;
        if (distance < result.distance)
        {
          result = { distance, b, ball.centre };
        }
      }
    }
  }
  return result;
}

double BranchBalls::halfWidth(const Ball& ball, const glm::dvec3& rise, double high) const
{
  const glm::dvec3 across = glm::cross(rise, probe_.closest(ball.centre) - ball.centre);
  const double size = glm::length(across);
  if (!(size > 0.0) || high <= ball.radius)
  {
    return ball.radius;
  }
  const glm::dvec3 direction = across / size;
  return probe_.wayOut(ball.centre, -direction, probe_.wayOut(ball.centre, direction, high));
}

BranchRise BranchBalls::rise(std::size_t branch, double enough) const
{
  const std::vector<Ball>& balls = branches_[branch].balls;
  std::vector<Outside> outsides(balls.size());
  tbb::parallel_for(std::size_t{ 1 }, std::max<std::size_t>(1, balls.size()),
    [&](std::size_t i) { outsides[i] = this->outside(balls[i].centre, branch); });
  BranchRise result;
  for (std::size_t i = 1; i < balls.size(); ++i)
  {
    result.length = std::max(result.length, outsides[i].distance + balls[i].radius);
    if (outsides[i].distance > 0.0)
    {
      result.size = std::max(result.size, balls[i].radius);
    }
    result.neighbours.push_back(outsides[i].branch);
  }
  const double narrow = result.size > 0.0 ? result.length / (enough * result.size) : 0.0;
  double aspect = std::numeric_limits<double>::infinity();
  for (std::size_t i = balls.size(); i-- > 1 && aspect > std::max(kRound, narrow);)
  {
    if (outsides[i].distance > 0.0 && balls[i].radius >= kLarge * result.size)
    {
      const glm::dvec3 up = balls[i].centre - outsides[i].centre;
      const double high = std::min(2.0 * result.length, aspect * balls[i].radius);
      aspect = std::min(aspect, this->halfWidth(balls[i], up, high) / balls[i].radius);
    }
  }
  result.size *= result.size > 0.0 ? std::max(1.0, aspect) : 1.0;
  makeSet(result.neighbours);
  return result;
}

} // namespace medial

#include "balls/common_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Solves a square system in place by elimination with pivots; false if it is singular.
bool eliminate(std::vector<std::vector<double>>& rows)
{
  const std::size_t size = rows.size();
  for (std::size_t k = 0; k < size; ++k)
  {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < size; ++i)
    {
      pivot = std::abs(rows[i][k]) > std::abs(rows[pivot][k]) ? i : pivot;
    }
    std::swap(rows[k], rows[pivot]);
    if (std::abs(rows[k][k]) < 1e-14)
    {
      return false;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const double factor = i == k ? 0.0 : rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= size; ++j)
      {
        rows[i][j] -= factor * rows[k][j];
      }
    }
  }
  return true;
}

double power(const Ball& ball, const glm::dvec3& x)
{
  const glm::dvec3 d = x - ball.centre;
  return glm::dot(d, d) - ball.radius * ball.radius;
}

/// Returns the lowest point of equal power of some balls, relative to the first, if it lies between
/// their centres. The power there is the minimum of their largest power.
double minPower(const std::vector<Ball>& balls)
{
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  const std::size_t size = balls.size();
  const glm::dvec3 origin = balls[0].centre;
  // The unknowns are the shares of the centres, which sum to 1, and the common value.
  std::vector<std::vector<double>> rows(size + 1, std::vector<double>(size + 2, 1.0));
  for (std::size_t i = 0; i < size; ++i)
  {
    const glm::dvec3 c = balls[i].centre - origin;
    for (std::size_t j = 0; j < size; ++j)
    {
      rows[i][j] = -2.0 * glm::dot(c, balls[j].centre - origin);
    }
    rows[i][size] = -1.0;
    rows[i][size + 1] = balls[i].radius * balls[i].radius - glm::dot(c, c);
  }
  rows[size][size] = 0.0;
  if (!eliminate(rows))
  {
    return kNone;
  }
  glm::dvec3 x = origin;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double share = rows[i][size + 1] / rows[i][i];
    if (share < 0.0)
    {
      return kNone;
    }
    x += share * (balls[i].centre - origin);
  }
  return power(balls[0], x);
}

} // namespace

bool haveCommonPoint(const std::vector<Ball>& balls)
{
  // The largest power has its minimum at the lowest point of some of the balls (duality).
  double highest = -std::numeric_limits<double>::infinity();
  for (unsigned subset = 1; subset < (1U << balls.size()); ++subset)
  {
    std::vector<Ball> some;
    for (std::size_t i = 0; i < balls.size(); ++i)
    {
      if ((subset >> i & 1U) != 0U)
      {
        some.push_back(balls[i]);
      }
    }
    highest = std::max(highest, minPower(some));
  }
  return highest < 0.0;
}

} // namespace medial

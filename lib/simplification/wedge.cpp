#include "simplification/wedge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Triangles with a lower ratio of height to length have no reliable normal.
constexpr double kMinHeight = 1e-6;

/// Solves a square system in place by elimination with pivots; false where it is singular.
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
  const glm::dvec3 d = x - centreOf(ball);
  return glm::dot(d, d) - ball.w * ball.w;
}

/// The lowest point of equal power of some balls, relative to the first, if it lies between their
/// centres: the power there is the least that the largest of theirs can be.
double minPower(const std::vector<Ball>& balls)
{
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  const std::size_t size = balls.size();
  const glm::dvec3 origin = centreOf(balls[0]);
  // Unknown: the shares of the centres, which sum to 1, and the common value.
  std::vector<std::vector<double>> rows(size + 1, std::vector<double>(size + 2, 1.0));
  for (std::size_t i = 0; i < size; ++i)
  {
    const glm::dvec3 c = centreOf(balls[i]) - origin;
    for (std::size_t j = 0; j < size; ++j)
    {
      rows[i][j] = -2.0 * glm::dot(c, centreOf(balls[j]) - origin);
    }
    rows[i][size] = -1.0;
    rows[i][size + 1] = balls[i].w * balls[i].w - glm::dot(c, c);
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
    x += share * (centreOf(balls[i]) - origin);
  }
  return power(balls[0], x);
}

} // namespace

std::optional<Slab> slabOf(const Ball& a, const Ball& b, const Ball& c)
{
  const glm::dvec3 e = centreOf(b) - centreOf(a);
  const glm::dvec3 f = centreOf(c) - centreOf(a);
  const glm::dvec3 normal = glm::cross(e, f);
  const double twice = glm::length(normal);
  const double ee = glm::dot(e, e);
  const double ff = glm::dot(f, f);
  if (!(twice > kMinHeight * std::max(ee, ff)))
  {
    return std::nullopt;
  }
  // slope . e = a.w - b.w and slope . f = a.w - c.w, within the plane.
  const double ef = glm::dot(e, f);
  const double p = a.w - b.w;
  const double q = a.w - c.w;
  const double determinant = twice * twice;
  Slab slab;
  slab.slope = ((p * ff - q * ef) * e + (q * ee - p * ef) * f) / determinant;
  const double sine2 = 1.0 - glm::dot(slab.slope, slab.slope);
  if (!(sine2 > 0.0))
  {
    return std::nullopt;
  }
  slab.sine = std::sqrt(sine2);
  slab.up = normal / twice;
  slab.area = 0.5 * twice;
  return slab;
}

std::optional<Cone> coneOf(const Ball& a, const Ball& b)
{
  Cone cone;
  cone.axis = centreOf(b) - centreOf(a);
  cone.length = glm::length(cone.axis);
  const double difference = a.w - b.w;
  if (!(cone.length > std::abs(difference)))
  {
    return std::nullopt;
  }
  cone.axis /= cone.length;
  cone.slope = difference / cone.length;
  cone.sine = std::sqrt(1.0 - cone.slope * cone.slope);
  return cone;
}

glm::dvec3 anyPerpendicular(const glm::dvec3& unitVector)
{
  const glm::dvec3 size = glm::abs(unitVector);
  const bool x = size.x <= size.y && size.x <= size.z;
  const bool y = !x && size.y <= size.z;
  const glm::dvec3 other(x ? 1.0 : 0.0, y ? 1.0 : 0.0, x || y ? 0.0 : 1.0);
  return glm::normalize(glm::cross(unitVector, other));
}

bool haveCommonPoint(const std::vector<Ball>& balls)
{
  // The largest power is least at the lowest point of some of the balls (duality).
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

#include "sign/winding_number.h"

#include "base/longest_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr double kFirstDerivative = 2.449489742783178; // square root of 6
} // namespace

double solidAngle(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& from)
{
  const glm::dvec3 a = corners[0] - from;
  const glm::dvec3 b = corners[1] - from;
  const glm::dvec3 c = corners[2] - from;
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double cosines =
    la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  const double volume = glm::dot(a, glm::cross(b, c));
  // In the plane of the triangle the angle is taken as none.
  return volume == 0.0 ? 0.0 : std::atan2(volume, cosines) / (2.0 * kPi);
}

/// The solid angle of a group over 4 pi as that of a dipole in its middle.
struct WindingNumber::Dipole
{
  glm::dvec3 areaVector;
  glm::dvec3 offset; ///< from the point to the middle
  double distance;

  Dipole(const glm::dvec3& vector, const glm::dvec3& toMiddle)
    : areaVector(vector)
    , offset(toMiddle)
    , distance(glm::length(toMiddle))
  {
  }

  double value() const
  {
    return glm::dot(areaVector, offset) / (4.0 * kPi * distance * distance * distance);
  }
  glm::dvec3 gradient() const
  {
    const double square = distance * distance;
    return (3.0 * glm::dot(areaVector, offset) / square * offset - areaVector) /
      (4.0 * kPi * square * distance);
  }
};

/// Bounds the difference between a group and its dipole with the gradient, inside a ball: terms of
/// first order in the group's extent have the moment, those of second order do not cancel out.
/// @param gap between the ball and the group, > 0.
double WindingNumber::dipoleError(const Node& node, double gap, double radius)
{
  const double reach = node.radius + radius;
  return (kFirstDerivative * node.moment + 3.0 * node.area * reach * reach / gap) /
    (4.0 * kPi * gap * gap * gap);
}

WindingNumber::WindingNumber(TriangleChain chain)
  : chain_(std::move(chain))
{
  std::vector<int> all(chain_.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  nodes_.reserve(2 * all.size());
  if (!all.empty())
  {
    this->build(all.data(), all.data() + all.size());
  }
}

int WindingNumber::build(int* begin, int* end)
{
  const auto index = static_cast<int>(nodes_.size());
  Node node;
  this->measure(begin, end, node);
  nodes_.push_back(node);
  if (end - begin == 1)
  {
    nodes_[index].triangle = *begin;
  }
  else
  {
    glm::dvec3 low(HUGE_VAL);
    glm::dvec3 high(-HUGE_VAL);
    for (const int* t = begin; t != end; ++t)
    {
      low = glm::min(low, this->middle(*t));
      high = glm::max(high, this->middle(*t));
    }
    const glm::dvec3 size = high - low;
    const int axis = longestAxis(size);
    int* half = begin + (end - begin) / 2;
    std::nth_element(begin, half, end,
      [&](int a, int b) {
        return std::make_pair(this->middle(a)[axis], a) < std::make_pair(this->middle(b)[axis], b);
      });
    this->build(begin, half);
    this->build(half, end);
  }
  nodes_[index].next = static_cast<int>(nodes_.size());
  return index;
}

glm::dvec3 WindingNumber::areaVector(const WeightedTriangle& triangle) const
{
  const auto [a, b, c] = chain_.cornersOf(triangle);
  return 0.5 * static_cast<double>(triangle.weight) * glm::cross(b - a, c - a);
}

glm::dvec3 WindingNumber::middle(int triangle) const
{
  const auto [a, b, c] = chain_.cornersOf(chain_.triangles[triangle]);
  return (a + b + c) / 3.0;
}

void WindingNumber::measure(const int* begin, const int* end, Node& node) const
{
  glm::dvec3 weighted(0.0);
  glm::dvec3 sum(0.0);
  for (const int* t = begin; t != end; ++t)
  {
    const glm::dvec3 vector = this->areaVector(chain_.triangles[*t]);
    const double area = glm::length(vector);
    node.areaVector += vector;
    node.area += area;
    weighted += area * this->middle(*t);
    sum += this->middle(*t);
  }
  node.middle = node.area > 0.0 ? weighted / node.area : sum / static_cast<double>(end - begin);
  glm::dmat3 moment(0.0);
  for (const int* t = begin; t != end; ++t)
  {
    const WeightedTriangle& triangle = chain_.triangles[*t];
    moment += glm::outerProduct(this->areaVector(triangle), this->middle(*t) - node.middle);
    for (const glm::dvec3& corner : chain_.cornersOf(triangle))
    {
      node.radius = std::max(node.radius, glm::distance(corner, node.middle));
    }
  }
  node.moment = std::sqrt(glm::dot(moment[0], moment[0]) + glm::dot(moment[1], moment[1]) +
    glm::dot(moment[2], moment[2]));
}

Interval WindingNumber::bounds(const glm::dvec3& point, double tolerance) const
{
  double value = 0.0;
  double error = 0.0;
  for (int index = 0; index < static_cast<int>(nodes_.size());)
  {
    const Node& node = nodes_[index];
    if (node.triangle >= 0)
    {
      const WeightedTriangle& triangle = chain_.triangles[node.triangle];
      value += triangle.weight * solidAngle(chain_.cornersOf(triangle), point);
      ++index;
      continue;
    }
    const Dipole dipole(node.areaVector, node.middle - point);
    const double gap = dipole.distance - node.radius;
    const double difference = gap > 0.0 ? dipoleError(node, gap, 0.0) : HUGE_VAL;
    if (difference <= tolerance)
    {
      value += dipole.value();
      error += difference;
    }
    index = difference <= tolerance ? node.next : index + 1;
  }
  return { value - error, value + error };
}

double WindingNumber::at(const glm::dvec3& point, double precision) const
{
  constexpr double kRefinement = 16.0;
  constexpr double kMinTolerance = 1e-6;
  for (double tolerance = 0.1 * precision; tolerance >= kMinTolerance; tolerance /= kRefinement)
  {
    const Interval value = this->bounds(point, tolerance);
    if (value.high - value.low <= 2.0 * precision)
    {
      return 0.5 * (value.low + value.high);
    }
  }
  return this->bounds(point, 0.0).low;
}

bool WindingNumber::isAboveHalf(const glm::dvec3& point) const
{
  for (const double tolerance : { 1e-2, 1e-3, 1e-4, 1e-5 })
  {
    const Interval value = this->bounds(point, tolerance);
    if (!value.contains(0.5))
    {
      return value.low > 0.5;
    }
  }
  return this->bounds(point, 0.0).low > 0.5;
}

bool WindingNumber::addDipole(double tolerance, AffineBound& sum) const
{
  const Node& all = nodes_.front();
  const Dipole dipole(all.areaVector, all.middle - sum.centre);
  const double gap = dipole.distance - sum.radius - all.radius;
  const double error = gap > 0.0 ? dipoleError(all, gap, sum.radius) : HUGE_VAL;
  if (error > tolerance)
  {
    return false;
  }
  sum.value += dipole.value();
  sum.gradient += dipole.gradient();
  sum.error += error;
  return true;
}

bool WindingNumber::mayMeet(const glm::dvec3& centre, double radius) const
{
  for (int index = 0; index < static_cast<int>(nodes_.size());)
  {
    const Node& node = nodes_[index];
    const bool apart = glm::distance(node.middle, centre) > node.radius + radius;
    if (!apart && node.triangle >= 0)
    {
      return true;
    }
    index = apart ? node.next : index + 1;
  }
  return false;
}

} // namespace medial

#include "sign/winding_number.h"

#include "base/longest_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace medial
{
namespace
{

/// Triangles in a leaf of the tree.
constexpr int kLeafSize = 3;
/// Groups are opened where they are larger than this many radii of the ball.
constexpr double kOpenAbove = 0.5;
/// Larger errors are not worth a look.
constexpr double kMaxError = 0.5;
/// Rounding of a sum.
constexpr double kRounding = 1e-9;

} // namespace

WindingNumber::WindingNumber(const TriangleChain& chain)
{
  for (const WeightedTriangle& weighted : chain.triangles)
  {
    Triangle triangle;
    triangle.corners = chain.cornersOf(weighted);
    triangle.weight = weighted.weight;
    const auto& [a, b, c] = triangle.corners;
    triangle.area = 0.5 * glm::length(glm::cross(b - a, c - a));
    triangle.middle = (a + b + c) / 3.0;
    triangle.radius = std::max({ glm::distance(a, triangle.middle),
      glm::distance(b, triangle.middle), glm::distance(c, triangle.middle) });
    // What has no area has no solid angle.
    if (triangle.area > 0.0)
    {
      triangles_.push_back(triangle);
    }
  }
  if (!triangles_.empty())
  {
    this->build(0, static_cast<int>(triangles_.size()));
  }
}

int WindingNumber::build(int begin, int end)
{
  const auto index = static_cast<int>(groups_.size());
  groups_.emplace_back();
  Group group;
  group.begin = begin;
  group.end = end;
  if (end - begin <= kLeafSize)
  {
    group.multipole = Multipole::ofTriangle(triangles_[begin].corners, triangles_[begin].weight);
    for (int t = begin + 1; t < end; ++t)
    {
      group.multipole = Multipole::ofBoth(group.multipole,
        Multipole::ofTriangle(triangles_[t].corners, triangles_[t].weight));
    }
  }
  else
  {
    glm::dvec3 low(HUGE_VAL);
    glm::dvec3 high(-HUGE_VAL);
    for (int t = begin; t < end; ++t)
    {
      low = glm::min(low, triangles_[t].middle);
      high = glm::max(high, triangles_[t].middle);
    }
    const int axis = longestAxis(high - low);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle,
      triangles_.begin() + end,
      [axis](const Triangle& a, const Triangle& b) { return a.middle[axis] < b.middle[axis]; });
    const int first = this->build(begin, middle);
    group.half = this->build(middle, end);
    group.multipole = Multipole::ofBoth(groups_[first].multipole, groups_[group.half].multipole);
  }
  for (int t = begin; t < end; ++t)
  {
    for (const glm::dvec3& corner : triangles_[t].corners)
    {
      group.radius = std::max(group.radius, glm::distance(corner, group.multipole.middle));
    }
  }
  groups_[index] = group;
  return index;
}

WindingNumber::View WindingNumber::everything() const
{
  View view;
  view.far.radius = HUGE_VAL;
  if (!groups_.empty())
  {
    view.near.push_back(0);
    view.nearError = HUGE_VAL;
  }
  return view;
}

double WindingNumber::errorOf(int item, const LocalExpansion& far, double tolerance) const
{
  if (item < 0)
  {
    const Triangle& triangle = triangles_[-1 - item];
    const double weight = std::abs(triangle.weight);
    const double distance = glm::distance(triangle.middle, far.centre);
    // The gap is somewhere between the first two.
    if (weight * triangleError(triangle.area, distance, far.radius) > tolerance)
    {
      return HUGE_VAL;
    }
    const double error =
      weight * triangleError(triangle.area, distance - triangle.radius, far.radius);
    return error <= tolerance ? error
                              : weight *
        triangleError(triangle.area, distanceToTriangle(triangle.corners, far.centre), far.radius);
  }
  const Group& group = groups_[item];
  return group.multipole.errorAt(glm::distance(group.multipole.middle, far.centre),
    group.radius + far.radius);
}

bool WindingNumber::isOpened(int item, double radius, bool closely) const
{
  return item >= 0 && (closely || groups_[item].radius > kOpenAbove * radius);
}

void WindingNumber::add(int item, LocalExpansion& far) const
{
  if (item < 0)
  {
    far.addTriangle(triangles_[-1 - item].corners, triangles_[-1 - item].weight);
  }
  else
  {
    groups_[item].multipole.addTo(far);
  }
}

WindingNumber::View WindingNumber::look(const View& outer, const glm::dvec3& centre, double radius,
  double tolerance, bool closely) const
{
  View view;
  view.far = outer.far.movedTo(centre, radius);
  constexpr std::size_t kUsual = 64;
  view.near.reserve(kUsual);
  std::vector<int> rest;
  rest.reserve(outer.near.size() + kUsual);
  rest.assign(outer.near.rbegin(), outer.near.rend());
  while (!rest.empty())
  {
    const int item = rest.back();
    rest.pop_back();
    const double error = tolerance > 0.0 && (item >= 0 || !closely)
      ? this->errorOf(item, view.far, view.nearError < kMaxError ? kMaxError : tolerance)
      : HUGE_VAL;
    if (error <= tolerance)
    {
      this->add(item, view.far);
      view.far.error += error;
    }
    else if (!this->isOpened(item, radius, closely))
    {
      view.near.push_back(item);
      view.nearError += error;
    }
    else if (groups_[item].half == 0)
    {
      for (int t = groups_[item].end - 1; t >= groups_[item].begin; --t)
      {
        rest.push_back(-1 - t);
      }
    }
    else
    {
      rest.push_back(groups_[item].half);
      rest.push_back(item + 1);
    }
  }
  return view;
}

WindingNumber::View WindingNumber::look(const View& outer, const glm::dvec3& centre, double radius,
  double tolerance) const
{
  return this->look(outer, centre, radius, tolerance, false);
}

WindingNumber::View WindingNumber::lookClosely(const View& outer, const glm::dvec3& centre,
  double radius, double tolerance) const
{
  return this->look(outer, centre, radius, tolerance, true);
}

Interval WindingNumber::bounds(const View& view) const
{
  if (view.far.error + view.nearError >= kMaxError)
  {
    return { -HUGE_VAL, HUGE_VAL };
  }
  LocalExpansion all = view.far;
  all.error += view.nearError;
  for (const int item : view.near)
  {
    this->add(item, all);
  }
  return all.bounds();
}

SolidAngleSums::Values WindingNumber::at(const View& view,
  const SolidAngleSums::Points& points) const
{
  SolidAngleSums near(points);
  for (const int item : view.near)
  {
    near.add(triangles_[-1 - item].corners, triangles_[-1 - item].weight);
  }
  SolidAngleSums::Values values;
  for (int i = 0; i < SolidAngleSums::kPoints; ++i)
  {
    values[i] = view.far.at(points[i]) + near.at(i);
  }
  return values;
}

Interval WindingNumber::bounds(const glm::dvec3& point, double tolerance) const
{
  const View view = this->lookClosely(this->everything(), point, 0.0, tolerance);
  double value = view.far.value;
  for (const int item : view.near)
  {
    const Triangle& triangle = triangles_[-1 - item];
    value += triangle.weight * solidAngle(triangle.corners, point);
  }
  const double error = view.far.error + kRounding;
  return { value - error, value + error };
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
  const Interval exact = this->bounds(point, 0.0);
  return 0.5 * (exact.low + exact.high) > 0.5;
}

} // namespace medial

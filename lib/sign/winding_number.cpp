#include "sign/winding_number.h"

#include "base/longest_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <tuple>

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
/// Continuations are of no use with larger errors, and cost too much for more triangles.
constexpr double kMaxContinuedError = 0.1;
constexpr std::size_t kMaxContinued = 100;
/// Rounding of a sum.
constexpr double kRounding = 1e-9;
/// No neighbour.
constexpr int kNone = -1;

double distanceToEdge(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& point)
{
  const glm::dvec3 along = b - a;
  const double t = std::clamp(glm::dot(point - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(a + t * along, point);
}

} // namespace

WindingNumber::WindingNumber(const TriangleChain& chain)
{
  for (const WeightedTriangle& weighted : chain.triangles)
  {
    Triangle triangle;
    triangle.corners = chain.cornersOf(weighted);
    triangle.points = weighted.corners;
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

void WindingNumber::joinTriangles()
{
  struct Edge
  {
    std::array<int, 3> key; ///< the points in order, and how often it runs that way
    int triangle;
    int place;
  };
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
  {
    const Triangle& triangle = triangles_[t];
    for (int i = 0; i < 3; ++i)
    {
      const auto [low, high] = std::minmax(triangle.points[i], triangle.points[(i + 1) % 3]);
      edges.push_back({ { low, high, std::abs(triangle.weight) }, static_cast<int>(t), i });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b)
    { return std::tie(a.key, a.triangle, a.place) < std::tie(b.key, b.triangle, b.place); });
  const auto runsUp = [this](const Edge& edge)
  {
    const Triangle& triangle = triangles_[edge.triangle];
    return (triangle.points[edge.place] == edge.key[0]) == (triangle.weight > 0);
  };
  for (const Triangle& triangle : triangles_)
  {
    planes_.emplace_back(triangle.corners);
  }
  neighbours_.assign(triangles_.size(), { kNone, kNone, kNone });
  for (std::size_t e = 1; e < edges.size(); ++e)
  {
    Edge& a = edges[e - 1];
    Edge& b = edges[e];
    if (a.key == b.key && runsUp(a) != runsUp(b) && neighbours_[a.triangle][a.place] == kNone)
    {
      neighbours_[a.triangle][a.place] = b.triangle;
      neighbours_[b.triangle][b.place] = a.triangle;
    }
  }
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

double WindingNumber::distanceTo(int triangle, const glm::dvec3& point) const
{
  return planes_.empty() ? TrianglePlanes(triangles_[triangle].corners).distanceTo(point)
                         : planes_[triangle].distanceTo(point);
}

double WindingNumber::errorOf(int item, const LocalExpansion& far, double tolerance) const
{
  if (item < 0)
  {
    const int t = -1 - item;
    const Triangle& triangle = triangles_[t];
    const double weight = std::abs(triangle.weight);
    const double distance = glm::distance(triangle.middle, far.centre);
    // The gap is somewhere between the first two.
    if (weight * triangleError(triangle.area, distance, far.radius) > tolerance)
    {
      return HUGE_VAL;
    }
    const double error =
      weight * triangleError(triangle.area, distance - triangle.radius, far.radius);
    return error <= tolerance
      ? error
      : weight * triangleError(triangle.area, this->distanceTo(t, far.centre), far.radius);
  }
  const Group& group = groups_[item];
  return group.multipole.errorAt(glm::distance(group.multipole.middle, far.centre),
    group.radius + far.radius);
}

bool WindingNumber::isOpened(int item, double radius, bool closely) const
{
  return item >= 0 && (closely || groups_[item].radius > kOpenAbove * radius);
}

void WindingNumber::add(int item, LocalExpansion& far, ExpansionSum& triangles) const
{
  if (item < 0)
  {
    const Triangle& triangle = triangles_[-1 - item];
    triangles.addTriangle(triangle.corners, triangle.weight);
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
  ExpansionSum triangles(centre);
  constexpr std::size_t kUsual = 64;
  view.near.reserve(kUsual);
  std::vector<int> rest;
  rest.reserve(outer.near.size() + kUsual);
  rest.assign(outer.near.rbegin(), outer.near.rend());
  while (!rest.empty())
  {
    const int item = rest.back();
    rest.pop_back();
    const double error = tolerance > 0.0 && (item >= 0 || radius > 0.0)
      ? this->errorOf(item, view.far, view.nearError < kMaxError ? kMaxError : tolerance)
      : HUGE_VAL;
    if (error <= tolerance)
    {
      this->add(item, view.far, triangles);
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
  triangles.addTo(view.far);
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
  ExpansionSum triangles(all.centre);
  for (const int item : view.near)
  {
    this->add(item, all, triangles);
  }
  triangles.addTo(all);
  return all.bounds();
}

double WindingNumber::addBorder(const View& view, ExpansionSum& sum) const
{
  double error = 0.0;
  for (const int item : view.near)
  {
    const int t = -1 - item;
    const Triangle& triangle = triangles_[t];
    for (int i = 0; i < 3 && error <= kMaxContinuedError; ++i)
    {
      const int neighbour = neighbours_[t][i];
      // Triangles are near in descending order.
      if (neighbour != kNone &&
        std::binary_search(view.near.begin(), view.near.end(), -1 - neighbour, std::greater<>()))
      {
        continue;
      }
      const glm::dvec3& from = triangle.corners[i];
      const glm::dvec3& to = triangle.corners[(i + 1) % 3];
      error += std::abs(triangle.weight) *
        edgeError(glm::distance(from, to), distanceToEdge(from, to, view.far.centre),
          view.far.radius);
      sum.addEdge(from, to, triangle.weight);
    }
  }
  return error;
}

std::optional<Continuation> WindingNumber::continued(const View& view) const
{
  const bool tried = !neighbours_.empty() && view.near.size() <= kMaxContinued &&
    std::all_of(view.near.begin(), view.near.end(), [](int item) { return item < 0; });
  if (!tried)
  {
    return {};
  }
  LocalExpansion smooth = view.far;
  ExpansionSum sum(smooth.centre);
  smooth.error += this->addBorder(view, sum);
  if (smooth.error > kMaxContinuedError)
  {
    return {};
  }
  for (const int item : view.near)
  {
    sum.addValue(triangles_[-1 - item].corners, triangles_[-1 - item].weight);
  }
  sum.addTo(smooth);
  Continuation continuation(smooth);
  for (const int item : view.near)
  {
    const Triangle& triangle = triangles_[-1 - item];
    if (this->distanceTo(-1 - item, smooth.centre) <= smooth.radius &&
      !continuation.addStep(triangle.corners, triangle.weight))
    {
      return {};
    }
  }
  return continuation;
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

bool WindingNumber::isBelow(double limit, const glm::dvec3& point) const
{
  for (const double tolerance : { 1e-2, 1e-3, 1e-4, 1e-5 })
  {
    const Interval value = this->bounds(point, tolerance);
    if (!value.contains(limit))
    {
      return value.high < limit;
    }
  }
  const Interval exact = this->bounds(point, 0.0);
  return 0.5 * (exact.low + exact.high) < limit;
}

} // namespace medial

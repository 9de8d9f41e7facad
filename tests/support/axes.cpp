#include "support/axes.h"

#include "base/disjoint_sets.h"
#include "support/brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace medial::test
{

namespace
{

using Side = std::pair<std::int64_t, std::int64_t>;

struct Ball
{
  Point3 centre;
  double radius;
};

Point3 along(const Point3& a, const Point3& u, double s)
{
  return { a[0] + s * u[0], a[1] + s * u[1], a[2] + s * u[2] };
}

Point3 between(const Point3& a, const Point3& b)
{
  return { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
}

double separation(const Point3& a, const Point3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double triangleArea(const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 u = between(a, b);
  const Point3 v = between(a, c);
  return 0.5 *
    std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

template <typename Cells>
void addSides(const Cells& cells, std::set<Side>& sides)
{
  for (const auto& cell : cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      sides.insert(std::minmax(cell[i], cell[(i + 1) % cell.size()]));
    }
  }
}

std::set<Side> sidesOf(const MedialAxis& axis)
{
  std::set<Side> sides;
  addSides(axis.quads, sides);
  addSides(axis.triangles, sides);
  addSides(axis.lines, sides);
  return sides;
}

Ball mix(const MedialAxis& axis, const std::array<std::int64_t, 3>& cell, double s, double t)
{
  const double shares[3] = { 1.0 - s - t, s, t };
  Ball ball{ {}, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    ball.centre = along(ball.centre, axis.points[cell[i]], shares[i]);
    ball.radius += shares[i] * static_cast<double>(axis.radius[cell[i]]);
  }
  return ball;
}

/// Balls all over the cells; those of a quad over its two triangles.
std::vector<Ball> sampledBalls(const MedialAxis& axis, int samples)
{
  std::vector<std::array<std::int64_t, 3>> triangles = axis.triangles;
  for (const auto& q : axis.quads)
  {
    triangles.push_back({ q[0], q[1], q[2] });
    triangles.push_back({ q[0], q[2], q[3] });
  }
  std::vector<Ball> balls;
  for (const auto& triangle : triangles)
  {
    for (int i = 0; i <= samples; ++i)
    {
      for (int j = 0; i + j <= samples; ++j)
      {
        balls.push_back(mix(axis, triangle, 1.0 * i / samples, 1.0 * j / samples));
      }
    }
  }
  for (const auto& line : axis.lines)
  {
    for (int i = 0; i <= samples; ++i)
    {
      balls.push_back(mix(axis, { line[0], line[1], line[1] }, 1.0 * i / samples, 0.0));
    }
  }
  for (const std::int64_t v : axis.vertices)
  {
    balls.push_back(mix(axis, { v, v, v }, 0.0, 0.0));
  }
  return balls;
}

} // namespace

std::int64_t AxisBuilder::add(const Point3& point, double radius)
{
  axis.points.push_back(point);
  axis.radius.push_back(static_cast<float>(radius));
  return static_cast<std::int64_t>(axis.points.size()) - 1;
}

std::int64_t AxisBuilder::shared(const Point3& point, double radius)
{
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    if (separation(axis.points[i], point) < 1e-12)
    {
      return static_cast<std::int64_t>(i);
    }
  }
  return this->add(point, radius);
}

void AxisBuilder::addSheet(const Point3& origin, const Point3& u, const Point3& v, int cells,
  double radius)
{
  std::vector<std::int64_t> ids;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      ids.push_back(
        this->shared(along(along(origin, u, 1.0 * i / cells), v, 1.0 * j / cells), radius));
    }
  }
  const int row = cells + 1;
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const int k = j * row + i;
      axis.quads.push_back({ ids[k], ids[k + 1], ids[k + row + 1], ids[k + row] });
    }
  }
}

void AxisBuilder::addCurve(const Point3& a, const Point3& b, int cells, double radius)
{
  std::int64_t last = this->shared(a, radius);
  for (int i = 1; i <= cells; ++i)
  {
    const std::int64_t next = this->shared(along(a, between(a, b), 1.0 * i / cells), radius);
    axis.lines.push_back({ last, next });
    last = next;
  }
}

MedialModel ballModel(double radius, const Point3& centre)
{
  MedialModel model;
  model.centres = { centre };
  model.radii = { radius };
  return model;
}

MedialModel capsuleModel(double halfLength, double radius)
{
  MedialModel model;
  model.centres = { { 0, 0, -halfLength }, { 0, 0, halfLength } };
  model.radii = { radius, radius };
  model.lines = { { 0, 1 } };
  return model;
}

std::int64_t eulerCharacteristic(const MedialAxis& axis)
{
  return static_cast<std::int64_t>(axis.points.size() + axis.quads.size() + axis.triangles.size()) -
    static_cast<std::int64_t>(sidesOf(axis).size());
}

std::int64_t componentCount(const MedialAxis& axis)
{
  return countComponents(axis.points.size(), sidesOf(axis));
}

double areaOf(const MedialAxis& axis)
{
  double sum = 0.0;
  const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c)
  { sum += triangleArea(axis.points[a], axis.points[b], axis.points[c]); };
  for (const auto& t : axis.triangles)
  {
    add(t[0], t[1], t[2]);
  }
  for (const auto& q : axis.quads)
  {
    add(q[0], q[1], q[2]);
    add(q[0], q[2], q[3]);
  }
  return sum;
}

std::vector<double> distancesToModel(const MedialAxis& axis, const std::vector<Point3>& points,
  int samplesPerSide)
{
  const std::vector<Ball> balls = sampledBalls(axis, samplesPerSide);
  std::vector<double> distances(points.size(), std::numeric_limits<double>::infinity());
  parallelFor(points.size(),
    [&](std::size_t i)
    {
      for (const Ball& ball : balls)
      {
        distances[i] = std::min(distances[i], separation(points[i], ball.centre) - ball.radius);
      }
    });
  return distances;
}

} // namespace medial::test

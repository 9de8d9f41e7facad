#include "simplification/axis_balls.h"

#include "balls/ball_check.h"
#include "base/id_limits.h"
#include "base/range_check.h"
#include "medial/error.h"

#include <algorithm>
#include <string>

namespace medial
{
namespace
{

void checkSize(const char* name, std::size_t size, std::size_t points)
{
  if (size != points)
  {
    throw Error(ErrorCode::InvalidInput,
      "medial axis with " + std::to_string(size) + " values of " + name + " for " +
        std::to_string(points) + " points");
  }
}

void checkSizeIfAny(const char* name, std::size_t size, std::size_t points)
{
  checkSize(name, size == 0 ? points : size, points);
}

void checkArrays(const MedialAxis& axis)
{
  const std::size_t count = axis.points.size();
  requireCount("the medial axis", static_cast<std::int64_t>(count), "points");
  checkSize("radius", axis.radius.size(), count);
  checkSizeIfAny("separation angle", axis.separationAngle.size(), count);
  checkSizeIfAny("lambda", axis.lambda.size(), count);
  checkSizeIfAny("closest point A", axis.closestPointA.size(), count);
  checkSizeIfAny("closest point B", axis.closestPointB.size(), count);
  for (std::size_t i = 0; i < count; ++i)
  {
    checkBall(i, axis.points[i], axis.radius[i]);
  }
}

int checkedId(std::int64_t id, std::size_t count)
{
  if (id < 0 || id >= static_cast<std::int64_t>(count))
  {
    throwOutside("point index", id,
      closedRange<std::int64_t>(0, static_cast<std::int64_t>(count) - 1));
  }
  return static_cast<int>(id);
}

} // namespace

glm::dvec3 AxisBalls::toLocal(const Point3& world) const
{
  return glm::dvec3(world[0] - origin[0], world[1] - origin[1], world[2] - origin[2]) / unit;
}

glm::dvec3 AxisBalls::toLocal(const std::array<float, 3>& world) const
{
  return this->toLocal(Point3{ static_cast<double>(world[0]), static_cast<double>(world[1]),
    static_cast<double>(world[2]) });
}

Point3 AxisBalls::toWorld(const glm::dvec3& local) const
{
  return { origin[0] + unit * local.x, origin[1] + unit * local.y, origin[2] + unit * local.z };
}

AxisBalls ballsOf(const MedialAxis& axis)
{
  checkArrays(axis);
  const Bounds bounds = axis.points.empty() ? Bounds() : boundsOf(axis.points);
  double unit = bounds.diagonal();
  for (const float radius : axis.radius)
  {
    unit = std::max(unit, static_cast<double>(radius));
  }
  AxisBalls result{ {}, 1.0, {} };
  for (int k = 0; k < 3; ++k)
  {
    result.origin[k] = 0.5 * (bounds.min[k] + bounds.max[k]);
  }
  result.unit = unit > 0.0 ? unit : 1.0;
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    result.balls.push_back(
      { result.toLocal(axis.points[i]), static_cast<double>(axis.radius[i]) / result.unit });
  }
  return result;
}

std::vector<ClosestPair> closestPairsOf(const MedialAxis& axis, const AxisBalls& frame)
{
  std::vector<ClosestPair> pairs;
  const std::size_t count = axis.closestPointA.size();
  for (std::size_t i = 0; i < count && axis.closestPointB.size() == count; ++i)
  {
    pairs.push_back({ frame.toLocal(axis.closestPointA[i]), frame.toLocal(axis.closestPointB[i]) });
  }
  return pairs;
}

BallComplex complexOf(const MedialAxis& axis, const std::vector<Ball>& balls)
{
  const auto id = [&](std::int64_t corner) { return checkedId(corner, balls.size()); };
  const auto distance = [&](int a, int b)
  { return glm::distance(toVector(balls[a]), toVector(balls[b])); };
  BallComplex complex(static_cast<int>(balls.size()));
  for (const auto& quad : axis.quads)
  {
    const std::array<int, 4> q{ id(quad[0]), id(quad[1]), id(quad[2]), id(quad[3]) };
    const int first = distance(q[0], q[2]) <= distance(q[1], q[3]) ? 0 : 1;
    complex.addTriangle(q[first], q[first + 1], q[first + 2]);
    complex.addTriangle(q[first], q[first + 2], q[(first + 3) % 4]);
  }
  for (const auto& triangle : axis.triangles)
  {
    complex.addTriangle(id(triangle[0]), id(triangle[1]), id(triangle[2]));
  }
  for (const auto& line : axis.lines)
  {
    complex.addEdge(id(line[0]), id(line[1]));
  }
  std::for_each(axis.vertices.begin(), axis.vertices.end(), id);
  return complex;
}

} // namespace medial

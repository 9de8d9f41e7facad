#include "simplification/simplified_axis.h"

#include "medial/axis_curves.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

namespace medial
{
namespace
{

bool hasArea(const std::vector<Ball>& balls, const std::array<int, 3>& t)
{
  const glm::dvec3 a = balls[t[0]].centre;
  const glm::dvec3 b = balls[t[1]].centre - a;
  const glm::dvec3 c = balls[t[2]].centre - a;
  return glm::length(glm::cross(b, c)) > 1e-6 * std::max(glm::dot(b, b), glm::dot(c, c));
}

/// For every ball, finds the nearest of the points that it represents.
std::vector<int> nearestOriginals(const AxisBalls& frame, const SimplifiedBalls& simplified)
{
  const std::vector<Ball>& balls = simplified.balls;
  std::vector<int> nearest(balls.size(), -1);
  std::vector<double> min(balls.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const int to = simplified.representatives[i];
    const double distance = glm::distance(frame.balls[i].centre, balls[to].centre);
    if (distance < min[to])
    {
      min[to] = distance;
      nearest[to] = static_cast<int>(i);
    }
  }
  return nearest;
}

/// Returns the index in the result by vertex.
std::vector<std::int64_t> pointIds(const BallComplex& complex)
{
  std::vector<std::int64_t> ids(complex.vertexCount(), -1);
  std::int64_t next = 0;
  for (const int v : complex.vertices())
  {
    ids[v] = next++;
  }
  return ids;
}

void addPoints(const MedialAxis& axis, const AxisBalls& frame, const SimplifiedBalls& simplified,
  MedialAxis& result)
{
  const std::vector<int> nearest = nearestOriginals(frame, simplified);
  for (const int v : simplified.complex.vertices())
  {
    const double radius = simplified.balls[v].radius * frame.unit;
    result.points.push_back(frame.toWorld(simplified.balls[v].centre));
    result.radius.push_back(static_cast<float>(radius));
    const auto inherit = [&](const auto& from, auto& to)
    {
      if (!from.empty())
      {
        to.push_back(from[nearest[v]]);
      }
    };
    inherit(axis.separationAngle, result.separationAngle);
    inherit(axis.closestPointA, result.closestPointA);
    inherit(axis.closestPointB, result.closestPointB);
    if (!axis.separationAngle.empty() && !axis.lambda.empty())
    {
      const auto angle = static_cast<double>(result.separationAngle.back());
      result.lambda.push_back(static_cast<float>(radius * std::sin(0.5 * glm::radians(angle))));
    }
  }
}

void addCells(const SimplifiedBalls& simplified, MedialAxis& result)
{
  const BallComplex& complex = simplified.complex;
  const std::vector<std::int64_t> ids = pointIds(complex);
  std::set<std::pair<int, int>> edgesOfTriangles;
  for (const std::array<int, 3>& t : complex.triangles())
  {
    if (!hasArea(simplified.balls, t))
    {
      continue; // its edges are lines
    }
    result.triangles.push_back({ ids[t[0]], ids[t[1]], ids[t[2]] });
    for (int i = 0; i < 3; ++i)
    {
      edgesOfTriangles.insert(std::minmax(t[i], t[(i + 1) % 3]));
    }
  }
  for (const int edge : complex.edges())
  {
    const auto [a, b] = complex.edge(edge);
    if (edgesOfTriangles.count({ a, b }) == 0)
    {
      result.lines.push_back({ ids[a], ids[b] });
    }
  }
  for (const int v : complex.vertices())
  {
    if (complex.edgesOf(v).empty())
    {
      result.vertices.push_back(ids[v]);
    }
  }
}

} // namespace

MedialAxis simplifiedAxis(const MedialAxis& axis, const AxisBalls& frame,
  const SimplifiedBalls& simplified)
{
  MedialAxis result;
  result.sign = axis.sign;
  result.side = axis.side;
  result.solid = axis.solid;
  result.statistics = axis.statistics;
  addPoints(axis, frame, simplified, result);
  addCells(simplified, result);
  result.feature = axisFeatures(edgesOf(result), result.points.size());
  return result;
}

} // namespace medial

#include "mesh/corner_insertion.h"

#include "base/vectors.h"
#include "mesh/edge_halving.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

/// Returns which corner of a triangle lies on the edge between the other two, if one does.
std::optional<int> cornerOnEdge(const TriangleMesh& mesh, const std::array<int, 3>& corners)
{
  const auto at = [&](int i) { return toVector(mesh.points[corners[i % 3]]); };
  const std::array<double, 3> opposite{ glm::distance(at(1), at(2)), glm::distance(at(2), at(0)),
    glm::distance(at(0), at(1)) };
  const auto longest = std::max_element(opposite.begin(), opposite.end());
  const auto corner = static_cast<int>(longest - opposite.begin());
  const double first = opposite[(corner + 1) % 3];
  const double second = opposite[(corner + 2) % 3];
  if (!(*longest > std::max(first, second)) || std::min(first, second) == 0.0)
  {
    return std::nullopt;
  }
  const glm::dvec3 along = (at(corner + 2) - at(corner + 1)) / *longest;
  const glm::dvec3 way = at(corner) - at(corner + 1);
  const double height = glm::length(glm::cross(along, way));
  const double part = glm::dot(along, way);
  const double smaller = std::min(part, *longest - part);
  return smaller > 0.0 && height <= kMaxFlatAngle * smaller ? std::optional(corner) : std::nullopt;
}

/// A triangle with points on its sides.
struct DividedTriangle
{
  std::array<int, 3> corners;
  std::array<std::vector<int>, 3> between; ///< from each corner to the next

  std::vector<int> outline() const
  {
    std::vector<int> points;
    for (std::size_t side = 0; side < 3; ++side)
    {
      points.push_back(corners[side]);
      points.insert(points.end(), between[side].begin(), between[side].end());
    }
    return points;
  }

  bool repeatsPoint() const
  {
    std::vector<int> points = this->outline();
    std::sort(points.begin(), points.end());
    return std::adjacent_find(points.begin(), points.end()) != points.end();
  }
};

/// Appends the triangles into which the points on its sides cut a triangle.
void split(DividedTriangle whole, TriangleMesh& mesh)
{
  std::vector<DividedTriangle> pending{ std::move(whole) };
  while (!pending.empty())
  {
    const DividedTriangle triangle = std::move(pending.back());
    pending.pop_back();
    const auto& between = triangle.between;
    const auto most = std::max_element(between.begin(), between.end(),
      [](const auto& x, const auto& y) { return x.size() < y.size(); });
    if (most->empty())
    {
      mesh.triangles.push_back(triangle.corners);
      continue;
    }
    const auto side = static_cast<std::size_t>(most - between.begin());
    const std::size_t next = (side + 1) % 3;
    const std::size_t last = (side + 2) % 3;
    const auto middle = most->begin() + static_cast<std::ptrdiff_t>(most->size() / 2);
    const int top = triangle.corners[last];
    pending.push_back({ { *middle, triangle.corners[next], top },
      { std::vector<int>(middle + 1, most->end()), between[next], {} } });
    pending.push_back({ { triangle.corners[side], *middle, top },
      { std::vector<int>(most->begin(), middle), {}, between[last] } });
  }
}

/// Appends triangles that fill an outline which meets itself. Where it runs back over its own edges
/// there is nothing to fill.
void fill(const std::vector<int>& outline, TriangleMesh& mesh)
{
  std::vector<int> points;
  for (const int point : outline)
  {
    if (points.size() > 1 && points[points.size() - 2] == point)
    {
      points.pop_back();
    }
    else if (points.empty() || points.back() != point)
    {
      points.push_back(point);
    }
  }
  while (points.size() > 1 && points.front() == points.back())
  {
    points.pop_back();
  }
  while (points.size() > 2)
  {
    const std::size_t size = points.size();
    const int a = points[size - 2];
    const int b = points[size - 1];
    const int c = points[0];
    if (a == c)
    {
      points.erase(points.end() - 2, points.end());
      continue;
    }
    if (points[1] == b)
    {
      points.erase(points.begin(), points.begin() + 2);
      continue;
    }
    mesh.triangles.push_back({ a, b, c });
    points.pop_back();
  }
}

std::array<std::int64_t, 2> ascending(std::int64_t a, std::int64_t b)
{
  return { std::min(a, b), std::max(a, b) };
}

} // namespace

std::vector<CornerOnEdge> cornersOnEdges(const TriangleMesh& mesh,
  const std::function<std::int64_t(int)>& numberOf, const Checkpoint& checkpoint)
{
  std::vector<CornerOnEdge> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    checkpoint(i);
    const std::array<int, 3>& corners = mesh.triangles[i];
    if (const std::optional<int> corner = cornerOnEdge(mesh, corners))
    {
      const int point = corners[*corner];
      found.push_back(
        { ascending(numberOf(corners[(*corner + 1) % 3]), numberOf(corners[(*corner + 2) % 3])),
          numberOf(point), mesh.points[point] });
    }
  }
  return found;
}

bool hasUsableTriangle(const TriangleMesh& mesh)
{
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
    [&](const std::array<int, 3>& t)
    {
      return hasArea(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) &&
        !cornerOnEdge(mesh, t);
    });
}

CornerInsertion::CornerInsertion(const std::vector<CornerOnEdge>& corners)
{
  for (const CornerOnEdge& corner : corners)
  {
    const auto [found, isNew] = cornerOn_.insert({ corner.ends, corner });
    if (!isNew && corner.corner < found->second.corner)
    {
      found->second = corner;
    }
  }
}

std::vector<int> CornerInsertion::pointsBetween(int a, int b, const NumberOf& numberOf,
  const PointOf& pointOf) const
{
  std::vector<int> between;
  std::vector<std::array<int, 2>> pending{ { a, b } }; // the first part last
  while (!pending.empty())
  {
    const auto [start, end] = pending.back();
    pending.pop_back();
    const auto found = cornerOn_.find(ascending(numberOf(start), numberOf(end)));
    if (found != cornerOn_.end())
    {
      const int point = pointOf(found->second, start, end);
      pending.push_back({ point, end });
      pending.push_back({ start, point });
    }
    else if (end != b)
    {
      between.push_back(end);
    }
  }
  return between;
}

void CornerInsertion::divide(double maxEdge, const NumberOf& numberOf, const PointOf& pointOf,
  const Checkpoint& checkpoint, TriangleMesh& mesh) const
{
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::int64_t> cells;
  triangles.swap(mesh.triangles);
  cells.swap(mesh.triangleCells);
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    checkpoint(i);
    const auto& [a, b, c] = triangles[i];
    DividedTriangle divided{ { a, b, c },
      { this->pointsBetween(a, b, numberOf, pointOf), this->pointsBetween(b, c, numberOf, pointOf),
        this->pointsBetween(c, a, numberOf, pointOf) } };
    if (divided.repeatsPoint())
    {
      fill(divided.outline(), mesh);
    }
    else
    {
      split(std::move(divided), mesh);
    }
    mesh.triangleCells.resize(mesh.triangles.size(), cells[i]);
    requireFew(static_cast<double>(mesh.triangles.size()), maxEdge);
  }
}

} // namespace medial

#include "medial/medial/medial_cells.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace medial
{
namespace
{

/// Cells below this area (square voxels) are lines, lines below this length (voxels) vertices.
constexpr double kLeastArea = 1e-6;
constexpr double kLeastLength = 1e-5;

using Corners = std::vector<std::int64_t>;

/// For each point the first one of the same position.
std::vector<std::int64_t> weldedPoints(const std::vector<glm::dvec3>& points)
{
  std::vector<std::int64_t> order(points.size());
  std::iota(order.begin(), order.end(), std::int64_t{ 0 });
  std::sort(order.begin(), order.end(),
    [&](std::int64_t a, std::int64_t b)
    {
      const glm::dvec3& p = points[a];
      const glm::dvec3& q = points[b];
      return std::tie(p.x, p.y, p.z, a) < std::tie(q.x, q.y, q.z, b);
    });
  std::vector<std::int64_t> representative(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && points[order[i]] == points[order[i - 1]];
    representative[order[i]] = same ? representative[order[i - 1]] : order[i];
  }
  return representative;
}

double area(const std::vector<glm::dvec3>& points, const Corners& corners)
{
  glm::dvec3 twice(0.0);
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    twice += glm::cross(points[corners[i - 1]] - points[corners[0]],
      points[corners[i]] - points[corners[0]]);
  }
  return 0.5 * glm::length(twice);
}

/// The two corners that are farthest apart, in ascending order.
std::array<std::int64_t, 2> longestSpan(const std::vector<glm::dvec3>& points,
  const Corners& corners)
{
  std::array<std::int64_t, 2> span{ corners[0], corners[0] };
  double longest = -1.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (std::size_t j = i + 1; j < corners.size(); ++j)
    {
      const double length = glm::distance(points[corners[i]], points[corners[j]]);
      if (length > longest)
      {
        longest = length;
        span = { std::min(corners[i], corners[j]), std::max(corners[i], corners[j]) };
      }
    }
  }
  return span;
}

Corners distinctCorners(const std::array<std::int64_t, 4>& quad,
  const std::vector<std::int64_t>& representative)
{
  Corners corners;
  for (std::int64_t corner : quad)
  {
    const std::int64_t point = representative[corner];
    if (std::find(corners.begin(), corners.end(), point) == corners.end())
    {
      corners.push_back(point);
    }
  }
  return corners;
}

void addCell(const std::vector<glm::dvec3>& points, const Corners& corners, MedialAxis& axis)
{
  if (corners.size() >= 3 && area(points, corners) >= kLeastArea)
  {
    if (corners.size() == 4)
    {
      axis.quads.push_back({ corners[0], corners[1], corners[2], corners[3] });
    }
    else
    {
      axis.triangles.push_back({ corners[0], corners[1], corners[2] });
    }
    return;
  }
  const std::array<std::int64_t, 2> span = longestSpan(points, corners);
  if (glm::distance(points[span[0]], points[span[1]]) >= kLeastLength)
  {
    axis.lines.push_back(span);
  }
  else
  {
    axis.vertices.push_back(corners[0]);
  }
}

template <typename T>
void sortUnique(std::vector<T>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Calls `visit` with a reference to every point id in the cells.
template <typename Visit>
void forEachCorner(MedialAxis& axis, const Visit& visit)
{
  const auto each = [&](auto& cells)
  {
    for (auto& cell : cells)
    {
      std::for_each(cell.begin(), cell.end(), visit);
    }
  };
  each(axis.quads);
  each(axis.triangles);
  each(axis.lines);
  std::for_each(axis.vertices.begin(), axis.vertices.end(), visit);
}

void compactPoints(MedialComplex& complex, MedialAxis& axis)
{
  std::vector<std::int64_t> target(complex.points.size(), -1);
  forEachCorner(axis, [&](std::int64_t& corner) { target[corner] = 0; });
  MedialComplex used;
  for (std::size_t p = 0; p < complex.points.size(); ++p)
  {
    if (target[p] < 0)
    {
      continue;
    }
    target[p] = static_cast<std::int64_t>(used.points.size());
    used.points.push_back(complex.points[p]);
    used.incident.insert(used.incident.end(), complex.incident.begin() + complex.offsets[p],
      complex.incident.begin() + complex.offsets[p + 1]);
    used.offsets.push_back(used.incident.size());
  }
  forEachCorner(axis, [&](std::int64_t& corner) { corner = target[corner]; });
  complex = std::move(used);
}

} // namespace

void buildCells(MedialComplex& complex, MedialAxis& axis)
{
  const std::vector<std::int64_t> representative = weldedPoints(complex.points);
  for (const auto& quad : complex.quads)
  {
    addCell(complex.points, distinctCorners(quad, representative), axis);
  }
  for (std::int64_t vertex : complex.vertices)
  {
    axis.vertices.push_back(representative[vertex]);
  }
  sortUnique(axis.lines);
  sortUnique(axis.vertices);
  compactPoints(complex, axis);
}

} // namespace medial

#include "axis/sheets/axis_cells.h"

#include "axis/contraction.h"
#include "axis/edge_table.h"
#include "base/huge_pages.h"
#include "base/sorted_set.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

/// Polygons narrower than this (voxels) between two rims are curves: their inner edges up to
/// kAcross are contracted.
constexpr double kNarrow = 0.3;
constexpr double kAcross = 0.75;
/// Cells below this area (square voxels) become lines.
constexpr double kMinArea = 1e-6;

using Id = Contraction::Id;

/// Up to four points in cyclic order.
class Corners
{
public:
  Corners() = default;
  explicit Corners(const std::array<Id, 4>& quad)
    : ids_(quad)
    , count_(quad.size())
  {
  }

  std::size_t size() const { return count_; }
  Id operator[](std::size_t i) const { return ids_[i]; }
  void add(Id id) { ids_[count_++] = id; }
  void removeLast() { --count_; }

private:
  std::array<Id, 4> ids_{};
  std::size_t count_ = 0;
};

/// Returns the moved points, as several of them may be at one crossing.
std::vector<Id> movedPoints(const BisectorPoints& points)
{
  std::vector<Id> moved;
  for (std::size_t p = 0; p < points.moved.size(); ++p)
  {
    if (points.moved[p] != 0)
    {
      moved.push_back(static_cast<Id>(p));
    }
  }
  return moved;
}

/// Joins the ends of edges for which `wanted` holds.
template <typename Wanted>
void joinSides(const BisectorPoints& points, const Corners& corners, double limit,
  Contraction& contraction, const Wanted& wanted)
{
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Id p = corners[i];
    const Id q = corners[(i + 1) % corners.size()];
    if (wanted(p, q) && glm::distance(points.points[p].position, points.points[q].position) < limit)
    {
      contraction.join(p, q);
    }
  }
}

double area(const BisectorPoints& points, const Corners& corners)
{
  glm::dvec3 twice(0.0);
  const glm::dvec3& origin = points.points[corners[0]].position;
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    twice += glm::cross(points.points[corners[i - 1]].position - origin,
      points.points[corners[i]].position - origin);
  }
  return 0.5 * glm::length(twice);
}

void addLine(Id p, Id q, MedialAxis& axis)
{
  axis.lines.push_back({ std::min(p, q), std::max(p, q) });
}

double longestEdge(const BisectorPoints& points, const Corners& corners)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    longest = std::max(longest,
      glm::distance(points.points[corners[i]].position,
        points.points[corners[(i + 1) % corners.size()]].position));
  }
  return longest;
}

bool isNarrow(const BisectorPoints& points, const Corners& corners)
{
  return area(points, corners) < kNarrow * longestEdge(points, corners);
}

/// What is known of a quad as long as none of its corners are joined.
enum QuadShape : std::uint8_t
{
  kNarrowQuad = 1,
  kFlatQuad = 2 ///< without area
};

std::vector<std::uint8_t> shapesOf(const BisectorPoints& points,
  const std::vector<std::array<Id, 4>>& quads)
{
  std::vector<std::uint8_t> shapes(quads.size());
  tbb::parallel_for(std::size_t{ 0 }, quads.size(),
    [&](std::size_t i)
    {
      const Corners corners(quads[i]);
      const double size = area(points, corners);
      shapes[i] = (size < kNarrow * longestEdge(points, corners) ? kNarrowQuad : 0) |
        (size < kMinArea ? kFlatQuad : 0);
    });
  return shapes;
}

/// Whether a quad has four different corners, none of them joined.
bool isWhole(const std::array<Id, 4>& quad, const Contraction& contraction)
{
  return std::none_of(quad.begin(), quad.end(),
    [&](Id corner) { return contraction.isJoined(corner); });
}

/// @param corners in cyclic order, neighbours distinct.
void addCell(const BisectorPoints& points, const Corners& corners, MedialAxis& axis)
{
  const bool folded = corners.size() == 4 && (corners[0] == corners[2] || corners[1] == corners[3]);
  if (corners.size() == 1)
  {
    axis.vertices.push_back(corners[0]);
  }
  else if (corners.size() == 2 || folded || area(points, corners) < kMinArea)
  {
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      addLine(corners[i], corners[(i + 1) % corners.size()], axis);
    }
  }
  else if (corners.size() == 3)
  {
    axis.triangles.push_back({ corners[0], corners[1], corners[2] });
  }
  else
  {
    axis.quads.push_back({ corners[0], corners[1], corners[2], corners[3] });
  }
}

Corners contracted(const std::array<Id, 4>& quad, Contraction& contraction)
{
  Corners corners;
  for (const Id corner : quad)
  {
    const Id point = contraction.find(corner);
    if (corners.size() == 0 || corners[corners.size() - 1] != point)
    {
      corners.add(point);
    }
  }
  if (corners.size() > 1 && corners[0] == corners[corners.size() - 1])
  {
    corners.removeLast();
  }
  return corners;
}

/// Turns strips of polygons that are too narrow for sheets into curves.
void joinNarrowStrips(const BisectorPoints& points, const std::vector<std::array<Id, 4>>& quads,
  const std::vector<std::uint8_t>& shapes, Contraction& contraction)
{
  std::vector<Corners> narrow;
  std::vector<std::uint8_t> inNarrow(points.points.size(), 0);
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    const bool whole = isWhole(quads[q], contraction);
    if (whole && (shapes[q] & kNarrowQuad) == 0)
    {
      continue;
    }
    const Corners corners = contracted(quads[q], contraction);
    if (corners.size() >= 3 && (whole || isNarrow(points, corners)))
    {
      narrow.push_back(corners);
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        inNarrow[corners[i]] = 1;
      }
    }
  }
  if (narrow.empty())
  {
    return;
  }
  std::vector<EdgeTable::Edge> edges; // only those that are asked for
  for (const auto& quad : quads)
  {
    if (isWhole(quad, contraction) &&
      std::none_of(quad.begin(), quad.end(), [&](Id corner) { return inNarrow[corner] != 0; }))
    {
      continue;
    }
    const Corners corners = contracted(quad, contraction);
    for (std::size_t i = 0; corners.size() >= 3 && i < corners.size(); ++i)
    {
      const EdgeTable::Edge edge{ corners[i], corners[(i + 1) % corners.size()] };
      if (inNarrow[edge[0]] != 0 && inNarrow[edge[1]] != 0)
      {
        edges.push_back(edge);
      }
    }
  }
  const EdgeTable table(edges, points.points.size());
  const auto isRim = [&](Id p, Id q) { return table.count({ p, q }) == 1; };
  for (const Corners& corners : narrow)
  {
    int rims = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      rims += isRim(corners[i], corners[(i + 1) % corners.size()]) ? 1 : 0;
    }
    if (rims >= 2)
    {
      joinSides(points, corners, kAcross, contraction, [&](Id p, Id q) { return !isRim(p, q); });
    }
  }
}

/// Keeps the first of several cells over the same points. These exist only where points have become
/// one.
/// @param origins of the cells; empty if nobody asks.
template <typename Cell>
void removeDuplicates(const Contraction& contraction, std::vector<Cell>& cells,
  std::vector<std::size_t>& origins)
{
  std::vector<std::pair<Cell, std::size_t>> keys;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (std::any_of(cells[i].begin(), cells[i].end(),
          [&](Id corner) { return contraction.standsForOthers(corner); }))
    {
      keys.emplace_back(cells[i], i);
      std::sort(keys.back().first.begin(), keys.back().first.end());
    }
  }
  tbb::parallel_sort(keys.begin(), keys.end());
  std::vector<std::uint8_t> duplicate(cells.size(), 0);
  for (std::size_t i = 1; i < keys.size(); ++i)
  {
    duplicate[keys[i].second] = keys[i].first == keys[i - 1].first ? 1 : 0;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (duplicate[i] == 0)
    {
      cells[kept] = cells[i];
      if (!origins.empty())
      {
        origins[kept] = origins[i];
      }
      ++kept;
    }
  }
  cells.resize(kept);
  origins.resize(origins.empty() ? 0 : kept);
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

/// Removes lines along cells of higher dimension and vertices of other cells, since they add
/// nothing.
void removeCovered(std::size_t pointCount, MedialAxis& axis)
{
  if (!axis.lines.empty())
  {
    std::vector<std::uint8_t> onLine(pointCount, 0);
    for (const auto& line : axis.lines)
    {
      onLine[line[0]] = onLine[line[1]] = 1;
    }
    std::vector<EdgeTable::Edge> edges; // only those that are asked for
    const auto addEdgesOnLines = [&](const auto& cell)
    {
      if (std::count_if(cell.begin(), cell.end(), [&](Id corner) { return onLine[corner] != 0; }) >
        1)
      {
        addEdges(cell, edges);
      }
    };
    std::for_each(axis.quads.begin(), axis.quads.end(), addEdgesOnLines);
    std::for_each(axis.triangles.begin(), axis.triangles.end(), addEdgesOnLines);
    const EdgeTable table(edges, pointCount);
    axis.lines.erase(std::remove_if(axis.lines.begin(), axis.lines.end(),
                       [&](const auto& line) { return table.count(line) > 0; }),
      axis.lines.end());
  }
  if (!axis.vertices.empty())
  {
    std::vector<Id> vertices;
    vertices.swap(axis.vertices);
    std::vector<std::uint8_t> used(pointCount, 0);
    forEachCorner(axis, [&](Id corner) { used[corner] = 1; });
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(axis.vertices),
      [&](Id vertex) { return used[vertex] == 0; });
    makeSet(axis.vertices);
  }
}

void compactPoints(BisectorPoints& points, MedialAxis& axis, CellOrigins* origins)
{
  std::vector<Id> target(points.points.size(), -1);
  forEachCorner(axis, [&](Id corner) { target[corner] = 0; });
  std::size_t used = 0;
  for (std::size_t p = 0; p < points.points.size(); ++p)
  {
    if (target[p] == 0)
    {
      target[p] = static_cast<Id>(used);
      points.points[used] = points.points[p];
      points.moved[used] = points.moved[p];
      ++used;
      if (origins != nullptr)
      {
        origins->points.push_back(p);
      }
    }
  }
  points.points.resize(used);
  points.moved.resize(used);
  if (used < target.size())
  {
    forEachCorner(axis, [&](Id& corner) { corner = target[corner]; });
  }
}

std::vector<Id> representatives(const BisectorPoints& points, Contraction& contraction)
{
  std::vector<Id> result(points.points.size());
  for (std::size_t p = 0; p < result.size(); ++p)
  {
    result[p] = contraction.find(static_cast<Id>(p));
  }
  return result;
}

} // namespace

void buildCells(const std::vector<std::array<std::int64_t, 4>>& quads, BisectorPoints& points,
  MedialAxis& axis, CellOrigins* origins)
{
  Contraction contraction(points);
  joinEqualPoints(points, movedPoints(points), contraction);
  const std::vector<std::uint8_t> withShortEdges = quadsWithShortEdges(points, quads);
  joinShortEdges(points, quads, withShortEdges, contraction);
  const std::vector<std::uint8_t> shapes = shapesOf(points, quads);
  joinNarrowStrips(points, quads, shapes, contraction);
  // The point of a set replaces others, so new edges may be short.
  while (joinShortEdges(points, quads, withShortEdges, contraction))
  {
  }
  reserveLarge(axis.quads, quads.size());
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    if (isWhole(quads[q], contraction) && (shapes[q] & kFlatQuad) == 0)
    {
      axis.quads.push_back(quads[q]);
    }
    else
    {
      addCell(points, contracted(quads[q], contraction), axis);
    }
    if (origins != nullptr)
    {
      origins->quads.resize(axis.quads.size(), q);
      origins->triangles.resize(axis.triangles.size(), q);
    }
  }
  std::vector<std::size_t> none;
  removeDuplicates(contraction, axis.quads, origins != nullptr ? origins->quads : none);
  removeDuplicates(contraction, axis.triangles, origins != nullptr ? origins->triangles : none);
  // Flat polygons may have left equal lines, even if all their points are their own.
  makeSet(axis.lines);
  removeCovered(points.points.size(), axis);
  if (origins != nullptr)
  {
    origins->standsFor = representatives(points, contraction);
  }
  compactPoints(points, axis, origins);
}

void buildVertices(BisectorPoints& points, MedialAxis& axis, CellOrigins* origins)
{
  Contraction contraction(points);
  std::vector<Id> all(points.points.size());
  std::iota(all.begin(), all.end(), Id{ 0 });
  joinEqualPoints(points, std::move(all), contraction);
  for (std::size_t p = 0; p < points.points.size(); ++p)
  {
    const auto id = static_cast<Id>(p);
    if (contraction.find(id) == id)
    {
      axis.vertices.push_back(id);
    }
  }
  if (origins != nullptr)
  {
    origins->standsFor = representatives(points, contraction);
  }
  compactPoints(points, axis, origins);
}

} // namespace medial

#include "ranks/axis/axis_assembly.h"

#include "medial/axis_curves.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{

/// Ranks compare what became of points that are this near to each other's parts, in grid cells: of
/// all in cells with a point of the part, and of those at these.
constexpr int kCompared = 3;

template <typename Item>
void sortByNumber(std::vector<Item>& items)
{
  std::sort(items.begin(), items.end(),
    [](const Item& a, const Item& b) { return a.number < b.number; });
}

/// Returns the index of an item, or the number of items if it is missing.
template <typename Item>
std::size_t indexOf(const std::vector<Item>& items, std::int64_t number)
{
  const auto at = std::lower_bound(items.begin(), items.end(), number,
    [](const Item& item, std::int64_t value) { return item.number < value; });
  return at != items.end() && at->number == number ? static_cast<std::size_t>(at - items.begin())
                                                   : items.size();
}

BisectorPoints bisectorPointsOf(const std::vector<AxisPoint>& points)
{
  BisectorPoints result;
  for (const AxisPoint& point : points)
  {
    result.points.push_back({ point.position, { -1, point.a }, { -1, point.b } });
    result.moved.push_back(point.moved);
  }
  return result;
}

/// Which point stands for another, by their numbers.
struct StandIn
{
  std::int64_t number;
  std::int64_t standsFor;
  glm::ivec3 cell;
};

template <typename Cell>
std::int64_t firstPoint(const Cell& cell)
{
  return *std::min_element(cell.begin(), cell.end());
}

void renamePoints(const std::vector<std::int64_t>& target, MedialAxis& axis)
{
  const auto rename = [&](auto& points)
  {
    std::transform(points.begin(), points.end(), points.begin(),
      [&](std::int64_t point) { return target[point]; });
  };
  std::for_each(axis.quads.begin(), axis.quads.end(), rename);
  std::for_each(axis.triangles.begin(), axis.triangles.end(), rename);
  std::for_each(axis.lines.begin(), axis.lines.end(), rename);
  rename(axis.vertices);
}

} // namespace

void numberCells(Communicator& communicator, const PolygonKeys& polygons, std::int64_t span,
  AxisPiece& piece)
{
  const auto number = [&](const std::vector<GlobalKey>& keys, std::int64_t keySpan)
  {
    const GlobalNumbers numbers(communicator, keys, keySpan);
    for (const std::int64_t id : numbers.of(communicator, keys))
    {
      piece.globalCellIds.push_back(piece.cells + id);
    }
    piece.cells += numbers.total();
  };
  std::vector<GlobalKey> vertices;
  for (const std::int64_t vertex : piece.axis.vertices)
  {
    vertices.push_back({ piece.globalPointIds[vertex], 0 });
  }
  std::vector<GlobalKey> lines;
  for (const auto& [p, q] : piece.axis.lines)
  {
    lines.push_back({ piece.globalPointIds[p], piece.globalPointIds[q] });
  }
  number(vertices, piece.points);
  number(lines, piece.points);
  number(polygons.quads, span);
  number(polygons.triangles, span);
}

AxisAssembly::AxisAssembly(Communicator& communicator, const GridShare& share, const OwnAxis& own,
  int halo)
  : halo_(std::max(halo, kCompared + 1))
{
  const auto& last = share.whole().max;
  this->build(communicator, share, own);
  while (!this->agrees(communicator, share) && halo_ <= std::max({ last[0], last[1], last[2] }))
  {
    halo_ *= 2;
    this->build(communicator, share, own);
  }
}

void AxisAssembly::build(Communicator& communicator, const GridShare& share, const OwnAxis& own)
{
  const auto cellOf = [](const auto& item) { return item.cell; };
  // A quad reaches from its cell to the one before.
  given_ = share.spread(communicator, own.points, halo_ + 1, cellOf);
  quads_ = share.spread(communicator, own.quads, halo_, cellOf);
  sortByNumber(given_);
  sortByNumber(quads_);
  own_.resize(given_.size());
  std::transform(given_.begin(), given_.end(), own_.begin(),
    [&](const AxisPoint& point) { return share.owns(point.cell) ? 1 : 0; });
  this->buildAxis(own.pointsOnly);
}

void AxisAssembly::buildAxis(bool pointsOnly)
{
  points_ = bisectorPointsOf(given_);
  axis_ = {};
  origins_ = {};
  if (pointsOnly)
  {
    buildVertices(points_, axis_, &origins_);
    return;
  }
  std::vector<std::array<std::int64_t, 4>> corners(quads_.size());
  for (std::size_t q = 0; q < quads_.size(); ++q)
  {
    std::transform(quads_[q].corners.begin(), quads_[q].corners.end(), corners[q].begin(),
      [&](std::int64_t number) { return static_cast<std::int64_t>(indexOf(given_, number)); });
  }
  buildCells(corners, points_, axis_, &origins_);
}

bool AxisAssembly::agrees(Communicator& communicator, const GridShare& share) const
{
  std::vector<StandIn> own;
  for (std::size_t p = 0; p < given_.size(); ++p)
  {
    if (own_[p] != 0)
    {
      own.push_back({ given_[p].number, given_[origins_.standsFor[p]].number, given_[p].cell });
    }
  }
  const auto cellOf = [](const StandIn& item) { return item.cell; };
  bool alike = true;
  for (const StandIn& theirs : share.spread(communicator, own, kCompared, cellOf))
  {
    const std::size_t p = indexOf(given_, theirs.number);
    alike = alike && p < given_.size() && given_[origins_.standsFor[p]].number == theirs.standsFor;
  }
  return maximum(communicator, alike ? 0 : 1) == 0;
}

AxisPiece AxisAssembly::piece(Communicator& communicator, const AxisOrder& order,
  BisectorPoints& points) const
{
  AxisPiece piece;
  PolygonKeys polygons;
  std::vector<std::int64_t> target = this->takeCells(piece.axis, polygons);
  std::vector<GlobalKey> ownKeys;
  std::vector<GlobalKey> keys;
  const std::vector<AxisFeature> features = axisFeatures(edgesOf(axis_), points_.points.size());
  points = {};
  for (std::size_t p = 0; p < target.size(); ++p)
  {
    const GlobalKey key{ given_[origins_.points[p]].number, 0 };
    if (this->isOwn(static_cast<std::int64_t>(p)))
    {
      ownKeys.push_back(key);
    }
    if (target[p] >= 0)
    {
      target[p] = static_cast<std::int64_t>(keys.size());
      keys.push_back(key);
      points.points.push_back(points_.points[p]);
      points.moved.push_back(points_.moved[p]);
      piece.axis.feature.push_back(features[p]);
    }
  }
  renamePoints(target, piece.axis);
  const GlobalNumbers numbers(communicator, ownKeys, order.span());
  piece.globalPointIds = numbers.of(communicator, keys);
  piece.points = numbers.total();
  numberCells(communicator, polygons, order.span(), piece);
  return piece;
}

/// Takes the cells of this rank, with the numbers of their points here.
/// @return for each point not -1 if it is used.
std::vector<std::int64_t> AxisAssembly::takeCells(MedialAxis& taken, PolygonKeys& polygons) const
{
  std::vector<std::int64_t> used(points_.points.size(), -1);
  const auto take = [&](const auto& cells, auto& own, const auto& found)
  {
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (this->isOwn(firstPoint(cells[i])))
      {
        own.push_back(cells[i]);
        std::for_each(cells[i].begin(), cells[i].end(),
          [&](std::int64_t point) { used[point] = 0; });
        found(i);
      }
    }
  };
  take(axis_.quads, taken.quads,
    [&](std::size_t i) {
      polygons.quads.push_back({ quads_[origins_.quads[i]].number, 0 });
    });
  take(axis_.triangles, taken.triangles,
    [&](std::size_t i) {
      polygons.triangles.push_back({ quads_[origins_.triangles[i]].number, 0 });
    });
  take(axis_.lines, taken.lines, [](std::size_t) {});
  for (const std::int64_t vertex : axis_.vertices)
  {
    if (this->isOwn(vertex))
    {
      taken.vertices.push_back(vertex);
      used[vertex] = 0;
    }
  }
  return used;
}

} // namespace medial

#include "ranks/axis/solid_piece.h"

#include "medial/axis_curves.h"
#include "ranks/axis/axis_assembly.h"
#include "ranks/axis/global_numbers.h"
#include "ranks/collective.h"
#include "thinning/sound_cells.h"

#include <algorithm>
#include <iterator>

namespace medial
{
namespace
{

/// Tells the others in a halo where the points of this rank are.
void tellPoints(Communicator& communicator, const GridShare& share, const CornerNumbers& corners,
  SolidPiece& solid)
{
  std::vector<ChangedCorner> own;
  for (std::size_t p = 0; p < solid.own.size(); ++p)
  {
    if (solid.own[p] != 0)
    {
      own.push_back({ solid.numbers[p], solid.axis.points.points[p] });
    }
  }
  const auto cellOf = [&](const ChangedCorner& corner) { return corners.cell(corner.number); };
  for (const ChangedCorner& corner : share.spread(communicator, own, kTold, cellOf))
  {
    const std::size_t p = solid.find(corner.number);
    if (p < solid.own.size() && solid.own[p] == 0)
    {
      solid.axis.points.points[p] = corner.point;
    }
  }
}

/// This rank's cells of a solid.
struct OwnCells
{
  std::vector<std::array<std::int64_t, 2>> lines;
  std::vector<std::array<std::int64_t, 4>> quads;
  std::vector<std::int64_t> vertices;
  std::vector<std::uint8_t> used; ///< not 0 for points of these cells
};

/// @param polygons receives the numbers of the quads.
OwnCells ownCellsOf(const SolidPiece& solid, PolygonKeys& polygons)
{
  OwnCells own;
  own.used.resize(solid.numbers.size(), 0);
  const auto take = [&](const auto& cells, const auto& add)
  {
    std::int64_t last = -1;
    int order = 0; // among those with the same first point
    for (const auto& cell : cells)
    {
      const std::int64_t first = cell.front();
      order = first == last ? order + 1 : 0;
      last = first;
      if (solid.own[first] != 0)
      {
        std::for_each(cell.begin(), cell.end(), [&](std::int64_t p) { own.used[p] = 1; });
        add(cell, order);
      }
    }
  };
  take(solid.axis.lines, [&](const auto& line, int /*order*/) { own.lines.push_back(line); });
  take(solid.axis.quads,
    [&](const auto& quad, int order)
    {
      own.quads.push_back(quad);
      polygons.quads.push_back({ 3 * solid.numbers[quad[0]] + order, 0 });
    });
  for (const std::int64_t vertex : solid.axis.vertices)
  {
    if (solid.own[vertex] != 0)
    {
      own.vertices.push_back(vertex);
      own.used[vertex] = 1;
    }
  }
  return own;
}

/// The points of this rank's cells.
struct PointsOfCells
{
  MedialAxis& axis; ///< receives their features, and the cells
  BisectorPoints& points;
  std::vector<GlobalKey>& ownKeys; ///< of all points that the rank owns
  std::vector<GlobalKey>& keys;    ///< of the points here
};

/// Adds the points that cells use.
/// @return the ids that they get, by their indices in the solid.
std::vector<std::int64_t> addPoints(const SolidPiece& solid, const std::vector<std::uint8_t>& used,
  PointsOfCells& result)
{
  MedialAxis around;
  around.quads = solid.axis.quads;
  around.lines = solid.axis.lines;
  around.vertices = solid.axis.vertices;
  const std::vector<AxisFeature> features = axisFeatures(edgesOf(around), solid.numbers.size());
  std::vector<std::int64_t> ids(used.size(), -1);
  for (std::size_t p = 0; p < ids.size(); ++p)
  {
    const GlobalKey key{ solid.numbers[p], 0 };
    if (solid.own[p] != 0)
    {
      result.ownKeys.push_back(key);
    }
    if (used[p] != 0)
    {
      ids[p] = static_cast<std::int64_t>(result.keys.size());
      result.keys.push_back(key);
      result.points.points.push_back(solid.axis.points.points[p]);
      result.points.moved.push_back(solid.axis.points.moved[p]);
      result.axis.feature.push_back(features[p]);
    }
  }
  return ids;
}

/// Adds this rank's cells of a solid, and the points that they use.
void addCellsOf(const SolidPiece& solid, PolygonKeys& polygons, PointsOfCells& result)
{
  const OwnCells own = ownCellsOf(solid, polygons);
  const std::vector<std::int64_t> ids = addPoints(solid, own.used, result);
  const auto idOf = [&](std::int64_t p) { return ids[p]; };
  const auto renamed = [&](auto cell)
  {
    std::transform(cell.begin(), cell.end(), cell.begin(), idOf);
    return cell;
  };
  MedialAxis& axis = result.axis;
  std::transform(own.lines.begin(), own.lines.end(), std::back_inserter(axis.lines), renamed);
  std::transform(own.quads.begin(), own.quads.end(), std::back_inserter(axis.quads), renamed);
  std::transform(own.vertices.begin(), own.vertices.end(), std::back_inserter(axis.vertices), idOf);
}

} // namespace

std::size_t SolidPiece::find(std::int64_t number) const
{
  const auto found = std::lower_bound(numbers.begin(), numbers.end(), number);
  return found != numbers.end() && *found == number
    ? static_cast<std::size_t>(found - numbers.begin())
    : numbers.size();
}

void keepSound(Communicator& communicator, const GridShare& share, const CornerNumbers& corners,
  const std::vector<BisectorPoint>& before, SolidPiece& solid)
{
  tellPoints(communicator, share, corners, solid);
  std::vector<BisectorPoint>& points = solid.axis.points.points;
  const auto hasMoved = [&](std::int64_t p) { return points[p].position != before[p].position; };
  std::vector<std::uint8_t> used(points.size(), 0);
  std::vector<NumberedCorners> cells;
  const auto addMoved = [&](const auto& some)
  {
    for (const auto& cell : some)
    {
      if (solid.own[cell.front()] != 0 && std::any_of(cell.begin(), cell.end(), hasMoved))
      {
        cells.push_back(solid.numbered(cell));
        std::for_each(cell.begin(), cell.end(), [&](std::int64_t p) { used[p] = 1; });
      }
    }
  };
  addMoved(solid.axis.lines);
  addMoved(solid.axis.quads);
  std::vector<MovedCorner> moving;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (used[p] != 0)
    {
      moving.push_back({ solid.numbers[p], before[p], points[p] });
    }
  }
  AxisPatch patch(communicator, moving, cells);
  const std::vector<BisectorPoint> moved = patch.axis.points.points;
  keepCellsSound(patch.before, patch.axis);
  std::vector<std::int64_t> restored;
  for (std::size_t p = 0; p < moved.size(); ++p)
  {
    if (patch.axis.points.points[p].position != moved[p].position)
    {
      restored.push_back(patch.numbers[p]);
    }
  }
  restored = flattened(gathered(communicator, restored));
  for (const std::int64_t number : restored)
  {
    const std::size_t p = solid.find(number);
    if (p < points.size())
    {
      points[p] = before[p];
    }
  }
}

AxisPiece pieceOf(Communicator& communicator, const CornerNumbers& corners,
  const std::vector<SolidPiece>& solids, BisectorPoints& points)
{
  AxisPiece piece;
  PolygonKeys polygons;
  std::vector<GlobalKey> ownKeys;
  std::vector<GlobalKey> keys;
  points = {};
  PointsOfCells result{ piece.axis, points, ownKeys, keys };
  for (const SolidPiece& solid : solids)
  {
    addCellsOf(solid, polygons, result);
  }
  const std::int64_t span =
    std::max<std::int64_t>(1, static_cast<std::int64_t>(solids.size())) * corners.count();
  const GlobalNumbers numbers(communicator, ownKeys, span);
  piece.globalPointIds = numbers.of(communicator, keys);
  piece.points = numbers.total();
  numberCells(communicator, polygons, 3 * span, piece);
  return piece;
}

} // namespace medial

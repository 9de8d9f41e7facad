#include "axis/axis_attributes.h"
#include "medial/ranks.h"
#include "ranks/collective.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// All that an axis knows of a point, with its number in the whole.
struct NumberedPoint
{
  std::int64_t number;
  Point3 position;
  float radius;
  float separationAngle;
  float lambda;
  std::array<float, 3> closestPointA;
  std::array<float, 3> closestPointB;
  AxisFeature feature;
};

/// A cell with its number in the whole.
struct NumberedCell
{
  std::int64_t number;
  std::array<std::int64_t, 4> corners; ///< numbers of points; -1 for those that it has not
};

std::vector<NumberedPoint> pointsOf(const AxisPiece& piece)
{
  const MedialAxis& axis = piece.axis;
  std::vector<NumberedPoint> points;
  for (std::size_t p = 0; p < axis.points.size(); ++p)
  {
    points.push_back(
      { piece.globalPointIds[p], axis.points[p], axis.radius[p], axis.separationAngle[p],
        axis.lambda[p], axis.closestPointA[p], axis.closestPointB[p], axis.feature[p] });
  }
  return points;
}

std::vector<NumberedCell> cellsOf(const AxisPiece& piece)
{
  std::vector<NumberedCell> cells;
  const auto add = [&](const auto& corners)
  {
    NumberedCell cell{ piece.globalCellIds[cells.size()], { -1, -1, -1, -1 } };
    std::transform(corners.begin(), corners.end(), cell.corners.begin(),
      [&](std::int64_t point) { return piece.globalPointIds[point]; });
    cells.push_back(cell);
  };
  for (const std::int64_t vertex : piece.axis.vertices)
  {
    add(std::array<std::int64_t, 1>{ vertex });
  }
  std::for_each(piece.axis.lines.begin(), piece.axis.lines.end(), add);
  std::for_each(piece.axis.quads.begin(), piece.axis.quads.end(), add);
  std::for_each(piece.axis.triangles.begin(), piece.axis.triangles.end(), add);
  return cells;
}

void set(const NumberedPoint& point, MedialAxis& axis)
{
  const std::int64_t p = point.number;
  axis.points[p] = point.position;
  axis.radius[p] = point.radius;
  axis.separationAngle[p] = point.separationAngle;
  axis.lambda[p] = point.lambda;
  axis.closestPointA[p] = point.closestPointA;
  axis.closestPointB[p] = point.closestPointB;
  axis.feature[p] = point.feature;
}

void add(const NumberedCell& cell, MedialAxis& axis)
{
  const auto& [a, b, c, d] = cell.corners;
  if (d >= 0)
  {
    axis.quads.push_back(cell.corners);
  }
  else if (c >= 0)
  {
    axis.triangles.push_back({ a, b, c });
  }
  else if (b >= 0)
  {
    axis.lines.push_back({ a, b });
  }
  else
  {
    axis.vertices.push_back(a);
  }
}

/// @param pointCount of the whole axis.
void bringTogether(const std::vector<NumberedPoint>& points, std::vector<NumberedCell>& cells,
  std::size_t pointCount, MedialAxis& whole)
{
  resizeAxisPoints(pointCount, whole);
  whole.feature.resize(pointCount);
  for (const NumberedPoint& point : points)
  {
    set(point, whole);
  }
  std::sort(cells.begin(), cells.end(),
    [](const NumberedCell& one, const NumberedCell& other) { return one.number < other.number; });
  for (const NumberedCell& cell : cells)
  {
    add(cell, whole);
  }
}

} // namespace

MedialAxis gatherMedialAxis(Communicator& communicator, const AxisPiece& piece)
{
  MedialAxis whole;
  agree(communicator,
    [&]
    {
      const std::vector<NumberedPoint> points = atFirst(communicator, pointsOf(piece));
      std::vector<NumberedCell> cells = atFirst(communicator, cellsOf(piece));
      whole.sign = piece.axis.sign;
      whole.side = piece.axis.side;
      whole.solid = piece.axis.solid;
      whole.statistics = piece.axis.statistics;
      if (communicator.rank() == 0)
      {
        bringTogether(points, cells, static_cast<std::size_t>(piece.points), whole);
      }
    });
  return whole;
}

AxisPiece onlyPiece(MedialAxis axis)
{
  AxisPiece piece;
  piece.points = static_cast<std::int64_t>(axis.points.size());
  piece.cells = axis.cellCount();
  piece.globalPointIds.resize(axis.points.size());
  piece.globalCellIds.resize(static_cast<std::size_t>(piece.cells));
  std::iota(piece.globalPointIds.begin(), piece.globalPointIds.end(), std::int64_t{ 0 });
  std::iota(piece.globalCellIds.begin(), piece.globalCellIds.end(), std::int64_t{ 0 });
  piece.axis = std::move(axis);
  return piece;
}

} // namespace medial

#pragma once

#include <cstdint>

namespace medial
{

/// Where a point of the axis lies. The kind of an edge follows from the number of polygons that
/// meet at it.
enum class AxisFeature : std::uint8_t
{
  Sheet = 0,    ///< inside a sheet, with polygons all around
  Rim = 1,      ///< where a sheet ends: edges of one polygon
  Seam = 2,     ///< where sheets meet: edges of three or more polygons
  Junction = 3, ///< where seams or curves meet or end, or a seam reaches a rim
  Curve = 4,    ///< on a line, where the axis is not a sheet
  Point = 5     ///< an isolated point
};

} // namespace medial

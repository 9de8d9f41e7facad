#pragma once

#include <cstdint>

namespace medial
{

/// What a point of the axis lies on. Edges of the mesh are told apart by the number of its polygons
/// that meet there.
enum class AxisFeature : std::uint8_t
{
  Sheet = 0,    ///< in the middle of polygons
  Rim = 1,      ///< where a sheet ends: edges with one polygon
  Seam = 2,     ///< where sheets meet: edges with three and more polygons
  Junction = 3, ///< where seams, curves or a seam and a rim meet or end
  Curve = 4,    ///< on lines, where the axis is no sheet
  Point = 5     ///< alone
};

} // namespace medial

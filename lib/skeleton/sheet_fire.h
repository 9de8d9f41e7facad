#pragma once

#include "base/checkpoint.h"
#include "medial/medial_axis.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// An edge of a medial axis that is left when all sheets have burned.
struct NetworkEdge
{
  std::array<std::int64_t, 2> ends; ///< ids of points
  /// When the last sheet beside it has burned; the radius if there was none. In local units.
  double time;
};

/// Up to this many radii a width is that of a tube; it is sqrt(2) at a flat cap.
constexpr double kTubeWidth = 1.7;

/// What a fire leaves of the sheets of a medial axis.
struct BurnedSheets
{
  std::vector<NetworkEdge> edges;
  /// Per point: when the last polygon around it has burned, its radius at least. Local units.
  std::vector<double> widths;
  std::int64_t opened = 0; ///< closed sheets that had to be opened
};

/// Burns the polygons of an axis by collapses, in the order in which a fire reaches them that
/// starts at the rims when it is as old as the radius there, and runs at unit speed along straight
/// lines. It passes an edge of several polygons only when all but one of them have burned.
///
/// Sheets without a rim enclose cavities. They are opened at the polygon of smallest radius.
/// @param positions, radii of the points of the axis, local units.
BurnedSheets burnSheets(const MedialAxis& axis, const std::vector<glm::dvec3>& positions,
  const std::vector<double>& radii, const Checkpoint& checkpoint);

} // namespace medial

#pragma once

#include "medial/axis_feature.h"
#include "medial/cell_topology.h"
#include "medial/grid.h"
#include "medial/run_statistics.h"
#include "medial/side.h"
#include "medial/sign_method.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// What simplifyAxis() did; all 0 if it was not called.
struct SimplificationStatistics
{
  std::int64_t inputPoints = 0;     ///< points of the full axis
  std::int64_t inputComponents = 0; ///< components of the full axis
  std::int64_t components = 0;      ///< components of the result
  std::int64_t joined = 0;          ///< lines added between components whose balls overlap
  std::int64_t forced = 0;  ///< balls merged although this closed a loop or a hollow of the shape
  std::int64_t dropped = 0; ///< components left out
  double seconds = 0.0;     ///< wall-clock time
};

/// A medial axis as points with attributes and cells over them.
struct MedialAxis
{
  std::vector<Point3> points;         ///< centres of medial balls, world coordinates
  std::vector<float> radius;          ///< distance to the surface, world units
  std::vector<float> separationAngle; ///< degrees, [0, 180]
  std::vector<float> lambda;          ///< radius * sin(separationAngle / 2), world units
  std::vector<std::array<float, 3>> closestPointA; ///< world coordinates
  std::vector<std::array<float, 3>> closestPointB; ///< world coordinates
  std::vector<AxisFeature> feature;                ///< where each point lies

  /// Cells by number of distinct corners; a cell never repeats a point and never has zero area.
  /// Where the axis is thinner than a sheet at this resolution, its cells are lines and vertices.
  std::vector<std::array<std::int64_t, 4>> quads;
  std::vector<std::array<std::int64_t, 3>> triangles; ///< ids of points
  std::vector<std::array<std::int64_t, 2>> lines;     ///< ids of points
  std::vector<std::int64_t> vertices;                 ///< ids of points

  SignMethod sign = SignMethod::None; ///< the method used, never Auto
  Side side = Side::Both;             ///< the side that was computed: Both if the field is unsigned
  /// Topology of the solid, if it was preserved. topologyOf(axis) is then the same, unless
  /// maxSpheres is too small for it.
  std::optional<CellTopology> solid;
  RunStatistics statistics;                ///< times and counts of the computation
  SimplificationStatistics simplification; ///< what simplifyAxis() did

  /// Number of cells of all kinds.
  std::int64_t cellCount() const
  {
    return static_cast<std::int64_t>(
      quads.size() + triangles.size() + lines.size() + vertices.size());
  }
};

} // namespace medial

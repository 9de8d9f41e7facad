#pragma once

#include "medial/axis_feature.h"
#include "medial/export.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

struct MedialAxis;

/// The edges of an axis, which determine its features.
struct AxisEdges
{
  /// Ids of two points.
  using Edge = std::array<std::int64_t, 2>;

  std::vector<Edge> polygonEdges; ///< of all polygons, a shared edge once for each polygon
  std::vector<Edge> lines;        ///< line cells
};

/// Collects the edges of the cells of an axis.
MEDIAL_EXPORT AxisEdges edgesOf(const MedialAxis& axis);

/// A polyline of rim, seam or curve edges that runs from junction to junction. A closed polyline
/// ends where it begins.
struct AxisCurve
{
  AxisFeature kind;                 ///< Rim, Seam or Curve
  std::vector<std::int64_t> points; ///< ids in their order along the polyline, two or more
};

/// Returns the feature of every point of an axis.
/// @param pointCount number of points; all ids in `edges` are below it.
MEDIAL_EXPORT std::vector<AxisFeature> axisFeatures(const AxisEdges& edges, std::size_t pointCount);

/// Returns all seams, rims and curves, each edge once, in ascending order of kind and first points.
/// @param pointCount number of points; all ids in `edges` are below it.
MEDIAL_EXPORT std::vector<AxisCurve> axisCurves(const AxisEdges& edges, std::size_t pointCount);

} // namespace medial

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

/// The cells of an axis as far as features depend on them.
struct AxisEdges
{
  /// Ids of the two points.
  using Edge = std::array<std::int64_t, 2>;

  std::vector<Edge> polygonEdges; ///< of all polygons, a shared edge once for each of them
  std::vector<Edge> lines;        ///< cells of two points
};

/// The edges of the cells of an axis.
MEDIAL_EXPORT AxisEdges edgesOf(const MedialAxis& axis);

/// A polyline of rim, seam or curve edges, from junction to junction; closed ones end where they
/// begin.
struct AxisCurve
{
  AxisFeature kind;                 ///< Rim, Seam or Curve
  std::vector<std::int64_t> points; ///< ids, two or more, in their order along the polyline
};

/// The feature of every point.
/// @param pointCount ids in `edges` are below it.
MEDIAL_EXPORT std::vector<AxisFeature> axisFeatures(const AxisEdges& edges, std::size_t pointCount);

/// All seams, rims and curves, each edge once; in ascending order of their kind and first points.
MEDIAL_EXPORT std::vector<AxisCurve> axisCurves(const AxisEdges& edges, std::size_t pointCount);

} // namespace medial

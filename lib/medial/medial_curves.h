#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

struct MedialAxis;

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

/// The cells of an axis as far as features depend on them.
struct AxisEdges
{
  /// Ids of the two points.
  using Edge = std::array<std::int64_t, 2>;

  std::vector<Edge> sides; ///< of all polygons, a shared side once for each of them
  std::vector<Edge> lines; ///< cells of two points
};

/// The edges of the cells of an axis.
AxisEdges edgesOf(const MedialAxis& axis);

/// A polyline of rim, seam or curve edges, from junction to junction; closed ones end where they
/// begin.
struct AxisCurve
{
  AxisFeature kind;                 ///< Rim, Seam or Curve
  std::vector<std::int64_t> points; ///< ids, two or more, in their order along the polyline
};

/// The feature of every point.
/// @param pointCount ids in `edges` are below it.
std::vector<AxisFeature> axisFeatures(const AxisEdges& edges, std::size_t pointCount);

/// All seams, rims and curves, each edge once; in ascending order of their kind and first points.
std::vector<AxisCurve> axisCurves(const AxisEdges& edges, std::size_t pointCount);

} // namespace medial

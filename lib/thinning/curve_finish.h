#pragma once

#include "axis/axis_geometry.h"
#include "axis/smooth_curve.h"
#include "thinning/thinned_axis.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace medial
{

/// A curve of an axis, and which of its ends must stay.
struct FreeCurve
{
  std::vector<std::int64_t> points; ///< ids; a closed one does not repeat its first
  Curve curve;                      ///< their positions
  bool firstStays = false;
  bool lastStays = false;
};

/// Returns the curves that have a zigzag. Points that are only on quads, and quads without a point
/// on a line, do not count.
std::vector<FreeCurve> zigzagCurves(const ThinnedAxis& axis);

/// Takes the zigzag of voxels out of a curve.
/// @param before points of the axis.
/// @param closest as SiteQuery; several threads may ask at once.
/// @return the curve's points.
std::vector<BisectorPoint> withoutZigzag(const AxisGeometry& geometry, FreeCurve curve,
  const std::vector<BisectorPoint>& before,
  const std::function<SitePoint(const glm::dvec3& x, const SitePoint& known)>& closest);

/// Takes the zigzag of voxels out of the curves of a thinned axis: their points move to where the
/// distance is largest in the cross-section, and a parabola is fitted to those around each of
/// them. Where curves meet sheets or each other they stay. Curves of fewer than four points have
/// no zigzag, and stay.
///
/// Only points move, so the topology stays.
void finishCurves(const AxisGeometry& geometry, ThinnedAxis& axis);

} // namespace medial

#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/grid.h"
#include "medial/triangle_mesh.h"
#include "support/named.h"

#include <functional>
#include <vector>

// Shapes whose medial axes, radii and separation angles are known as functions of position.
namespace medial::test
{

/// What is true at a point near the axis.
struct AxisTruth
{
  double offAxis = 0.0; ///< distance from the axis, to first order
  double radius = 0.0;  ///< at the axis there
  double angle = 0.0;   ///< separation angle there, degrees
};

struct AnalyticAxis
{
  /// Tessellation: the error of the facets falls with `spacing` squared.
  std::function<TriangleMesh(double spacing)> shape;
  Bounds bounds;  ///< of the grid, in which the axis is as described
  double spacing; ///< the coarsest; halved twice
  double angle;   ///< minimum separation angle, degrees
  Side side = Side::Interior;
  std::function<AxisTruth(const Point3&)> truth;
  /// False for points near seams, rims and ends, where the truth changes from one form to another.
  std::function<bool(const Point3&, double spacing)> regular = [](const Point3&, double)
  { return true; };
  bool isCurve = false; ///< or a point, which facets turn into a thin tangle of lines
  double area = 0.0;    ///< of the sheets inside the bounds; 0 where it has no closed form
};

/// Solids, then ellipsoid, eccentric shell, plates, point and plane, skew lines and a wedge.
std::vector<Named<AnalyticAxis>> analyticAxes();

/// Errors in grid steps, angles in degrees, area relative.
struct AnalyticErrors
{
  std::size_t points = 0;
  double positionMax = 0.0;
  double positionMean = 0.0;
  double radiusMax = 0.0;
  double radiusMean = 0.0;
  double angleMax = 0.0;
  double angleMean = 0.0;
  double area = 0.0;
};

AnalyticErrors analyticErrors(const AnalyticAxis& axis, double spacing);

} // namespace medial::test

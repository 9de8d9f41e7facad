#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/medial_model.h"

#include <array>
#include <vector>

// Medial axes made by hand, and what their balls describe.
namespace medial::test
{

/// An axis that has only points, radii and cells, to which functions add. Lengths are world units.
class AxisBuilder
{
public:
  std::int64_t add(const Point3& point, double radius);

  /// Grid of quads over the parallelogram origin + s u + t v, s and t in [0, 1], with `cells` cells
  /// along each edge and equal radii. Points equal to ones that are there already are shared.
  void addSheet(const Point3& origin, const Point3& u, const Point3& v, int cells, double radius);

  /// Lines between `cells` + 1 points from a to b.
  void addCurve(const Point3& a, const Point3& b, int cells, double radius);

  MedialAxis axis;

private:
  std::int64_t shared(const Point3& point, double radius);
};

MedialModel ballModel(double radius, const Point3& centre = {});
/// Two balls of the same radius at z = +-halfLength, and the cone between them.
MedialModel capsuleModel(double halfLength, double radius);

/// Euler characteristic of the cells with their edges: points - edges - lines + polygons.
std::int64_t eulerCharacteristic(const MedialAxis& axis);

/// Number of connected components.
std::int64_t componentCount(const MedialAxis& axis);

/// Sum of the areas of triangles and quads.
double areaOf(const MedialAxis& axis);

/// Distance from each point to the boundary of the union of balls, cones between the two balls of a
/// edge or line, and wedges between the three of a triangle, by sampling the cells densely: at most
/// `step` of the longest edge too large. Negative inside.
std::vector<double> distancesToModel(const MedialAxis& axis, const std::vector<Point3>& points,
  int samplesPerSide = 40);

} // namespace medial::test

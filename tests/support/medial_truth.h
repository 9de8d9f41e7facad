#pragma once

#include "medial/triangle_mesh.h"
#include "support/named.h"

#include <vector>

// Shapes whose medial axes are known in closed form.
namespace medial::test
{

/// A rotation that aligns no plane of a shape with the grid, and its inverse.
Point3 tilted(const Point3& point);
Point3 untilted(const Point3& point);
TriangleMesh tilted(TriangleMesh mesh);

struct MedialTruth
{
  TriangleMesh shape;
  /// The axis at `angle`: triangles, segments and points.
  TriangleMesh axis;
  /// Where sheets meet or end, and the parts of the axis that are not sheets: a grid thickens
  /// these.
  TriangleMesh curves;
  double angle;   ///< in degrees, different from the separation angle of any part of the axis
  double spacing; ///< of a grid that resolves the shape and does not show its facets
};

/// Half sides a >= b >= c. Its middle rectangle has separation angle 180 and the sheets to its
/// edges 90, so that only the rectangle is left for angles above.
MedialTruth boxTruth(const Point3& halfSides, double angle);
MedialTruth ballTruth();
MedialTruth capsuleTruth();
MedialTruth torusTruth();
/// Higher than wide: a segment and two cones.
MedialTruth cylinderTruth();
MedialTruth shellTruth();
MedialTruth tetrahedronTruth();

/// Shape and axis turned together.
MedialTruth tilted(const MedialTruth& truth);

/// All of the above, some of them tilted as well.
std::vector<Named<MedialTruth>> medialTruths();

} // namespace medial::test

#pragma once

#include "support/mesh_search.h"

#include <vector>

// Local thickness by branch and bound, in double precision; shares no code with the library.
namespace medial::test
{

/// What the diameter of the largest ball that contains a point may be.
struct DiameterBounds
{
  double min = 0.0; ///< world units
  double max = 0.0; ///< world units
};

/// Finds the diameter of the largest ball without a point of the mesh inside that contains a point
/// and has its centre in a box. It is discontinuous where a ball just contains the point, so two
/// diameters are found: of balls that contain it by `slack`, and of those that miss it by `slack`
/// at most.
/// @param tolerance of the diameters, world units.
DiameterBounds largestBallAround(const MeshSearch& search, const Bounds& centres,
  const Point3& point, double slack, double tolerance);

} // namespace medial::test

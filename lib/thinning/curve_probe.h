#pragma once

#include "sites/grid_frame.h"
#include "sites/site_set.h"
#include "thinning/cubical_complex.h"
#include "thinning/voxel_solid.h"

#include <cstdint>

namespace medial
{

/// Tells which edges a curve of the medial axis may follow. An oblique front of voxels leaves
/// others behind. The closest sites of the four voxels around an edge make the difference.
class CurveProbe
{
public:
  /// @param closestSites of all grid points.
  /// @param angle minimum separation angle theta, radians. Around a straight curve the four
  ///   directions are up to 135 degrees or more apart, wherever the curve crosses the square of the
  ///   voxels; no more than 120 degrees are therefore required.
  CurveProbe(const SiteSet& sites, const GridFrame& frame, const std::int32_t* closestSites,
    const DepthField& depth, double angle);

  /// Whether two of the four voxels around an edge are closest to parts of the surface that face
  /// away from each other by the angle. Voxels on the other side of the surface, around parts
  /// thinner than a voxel, count with the direction from which they see the surface; they need 120
  /// degrees, so that convex edges are not taken for such parts.
  bool separates(const CubicalComplex& complex, CubeCell edge) const;

private:
  /// Whether the interior of one face is closest to all voxels around an edge.
  bool seeOneFace(const CubicalComplex& complex, CubeCell edge) const;

  const SiteSet& sites_;
  GridFrame frame_;
  const std::int32_t* closestSites_;
  const DepthField& depth_;
  double cosine_;
};

} // namespace medial

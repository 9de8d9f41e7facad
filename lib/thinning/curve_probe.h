#pragma once

#include "sites/grid_frame.h"
#include "sites/site_set.h"
#include "thinning/cubical_complex.h"
#include "thinning/voxel_solid.h"

#include <cstdint>

namespace medial
{

/// Tells edges along which a curve of the medial axis may run from those that an oblique front of
/// voxels leaves behind: by the closest sites of the four voxels around them.
class CurveProbe
{
public:
  /// @param closestSites of all grid points.
  /// @param angle least separation angle theta, radians. Around a straight curve the four
  ///   directions are up to 135 degrees or more apart, wherever it crosses their square; from 120
  ///   degrees on that is what is asked for.
  CurveProbe(const SiteSet& sites, const GridFrame& frame, const std::int32_t* closestSites,
    const DepthField& depth, double angle);

  /// Whether two of the four voxels around an edge are closest to places of the surface that face
  /// away from each other by the angle. Voxels on the other side of the surface, around parts that
  /// are thinner than a voxel, count with the direction that they see the surface from, and for
  /// 120 degrees, so that convex edges are no such parts.
  bool separates(const CubicalComplex& complex, CubeCell edge) const;

private:
  /// Whether the voxels around an edge are all closest to the inside of one face.
  bool seeOneFace(const CubicalComplex& complex, CubeCell edge) const;

  const SiteSet& sites_;
  GridFrame frame_;
  const std::int32_t* closestSites_;
  const DepthField& depth_;
  double cosine_;
};

} // namespace medial

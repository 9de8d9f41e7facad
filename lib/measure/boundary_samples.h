#pragma once

#include "balls/ball_union.h"

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace medial
{

/// Points on the surface of a union of balls, cones and wedges.
struct BoundarySamples
{
  std::vector<glm::dvec3> even; ///< spread evenly by area
  /// One on each ball that shows, as far as a few tries find it: what is too small for samples
  /// counts as well.
  std::vector<glm::dvec3> ofBalls;
};

/// Samples the surface of a union. The points do not depend on the number of threads. The surface
/// of every part is sampled; samples inside other parts are dropped, and so are those where an
/// earlier part has the same surface.
/// @param areaPerSample > 0; less is taken where a small union would have too few samples.
/// @param tolerance points this deep inside another primitive still count as on the surface.
/// @param report called regularly with the share of the work that is done, in [0, 1]; its
///   exceptions end the work.
BoundarySamples boundarySamples(const BallUnion& solid, double areaPerSample, double tolerance,
  const std::function<void(double)>& report = {});

} // namespace medial

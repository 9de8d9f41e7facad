#pragma once

#include "sign/closed_surface.h"
#include "sign/rim_bound.h"
#include "sign/winding_number.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The winding number w of the lids of a surface. It jumps by one where a lid is crossed. Apart
/// from that it is smooth, and only the rims bound how fast it changes: the solid angle of a lid
/// depends on nothing else.
class Lids
{
public:
  explicit Lids(const ClosedSurface& surface);

  /// What is known in a ball: an affine function for the lids that are far, and the others.
  struct View
  {
    AffineBound far;
    std::vector<int> near;
  };

  /// Returns the view of everything, in which all lids are near.
  View everything() const;
  /// Returns the view of a ball inside that of another view.
  View look(const View& outer, const glm::dvec3& centre, double radius) const;

  /// Bounds w in the ball of a view, but for the whole numbers by which it jumps at lids: the
  /// values are those of a smooth function that equals w at the centre.
  Interval smoothBounds(const View& view) const;
  /// Whether a lid may meet the ball of a view.
  bool mayMeet(const View& view) const;

  /// Returns w at a point of the ball of a view, to +- 0.1.
  double roughly(const View& view, const glm::dvec3& point) const;
  /// Returns w at a point, to at least this precision.
  double at(const glm::dvec3& point, double precision) const;
  /// Returns w at a point, rounded to the nearest integer, halves upwards. Bounds are refined until
  /// only one integer is left; near a half all triangles are summed one by one.
  int rounded(const View& view, const glm::dvec3& point) const;

private:
  Interval bounds(const View& view, const glm::dvec3& point, double tolerance) const;

  std::vector<WindingNumber> windings_; ///< of every lid
  std::vector<RimBound> rims_;
};

} // namespace medial

#pragma once

#include "base/box_tree.h"
#include "base/half_line.h"
#include "sites/site_set.h"
#include "thickness/surface_answers.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>

namespace medial
{

/// Finds where a ray from the surface reaches the opposite surface.
class OppositeSurface
{
public:
  /// @param sites must outlive this. Uses the threads of the current arena.
  /// @param diagonal of the bounds of the whole mesh, local units.
  OppositeSurface(const SiteSet& sites, double diagonal);

  /// Returns a ray. It meets all boxes around what it can end on, so what is found does not depend
  /// on the boxes.
  /// @param diagonal as above.
  static HalfLine rayFrom(const glm::dvec3& start, const glm::dvec3& direction, double diagonal);

  /// Returns the first face that the ray meets, of several at the same distance the lowest; nothing
  /// if there is none. Right at the start two kinds of faces are passed over: one that the ray
  /// enters the solid through is another part of the surface that the ray starts on, by rounding;
  /// one that it meets at a right angle is that of a body which touches this one. So are faces that
  /// the ray runs along, such as the next one at a seam.
  /// @param ray as rayFrom() makes it.
  /// @param sign 1 for a ray in the solid, -1 for one outside.
  /// @param limit local units; faces beyond need not be found.
  std::optional<RayEnd> find(const HalfLine& ray, double sign, const RayStart& start,
    double limit = std::numeric_limits<double>::infinity()) const;

private:
  const SiteSet& sites_;
  double diagonal_;
  BoxTree tree_;
};

} // namespace medial

#pragma once

#include "axis/bisector_point.h"
#include "sign/inside_query.h"

#include <glm/glm.hpp>

#include <tbb/collaborative_call_once.h>

#include <functional>

namespace medial
{

/// Tells whether a bisector point is on the side of the surface that it was looked for on. Between
/// two grid points inside a solid there may be a gap, narrower than the grid is fine, and the
/// bisector of its walls.
///
/// Most answers follow from balls, which no surface enters. The others need an exact query, which
/// is built when it is first needed, by all threads that wait for it. Several threads may ask at
/// once.
class SideCheck
{
public:
  /// Tells whether a position is inside; local coordinates.
  using Inside = std::function<bool(const glm::dvec3& x)>;

  /// @param makeInside called when it is first needed.
  explicit SideCheck(std::function<Inside()> makeInside);
  explicit SideCheck(std::function<InsideQuery()> makeInside);

  /// @param known a point on the right side.
  /// @param reach no surface is nearer to it than this; 0 if that is not known.
  bool isAcross(const glm::dvec3& known, double reach, const BisectorPoint& point) const;

private:
  const Inside& inside() const;

  std::function<Inside()> makeInside_;
  mutable tbb::collaborative_once_flag once_;
  mutable Inside inside_;
};

} // namespace medial

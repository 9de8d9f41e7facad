#pragma once

#include "base/simd.h"

#include <glm/glm.hpp>

#include <array>
#include <limits>

namespace medial
{

/// Eight discs side by side, in local coordinates. A disc is a flat cylinder around a part of a
/// surface, a little larger than it by the rounding of single precision.
///
/// Where the part is smooth, its Voronoi regions widen slowly: they are made of vectors that are
/// orthogonal to the surface. Where the surface goes on all around with its faces turned the same
/// way, these lie in the cone around the normals of all faces at its sites. So a position in a
/// region is no farther from the axis than the radius and the slope of the cone, times the distance
/// along the axis, allow.
struct alignas(32) Discs
{
  using Lanes = std::array<float, kLanes>;
  using Lanes3 = std::array<Lanes, 3>;

  Lanes3 centre;
  Lanes3 normal; ///< unit vectors along the cylinders' axes
  Lanes radius;  ///< minus infinity in lanes without a disc, which puts them out of reach
  Lanes halfHeight;
  Lanes slope; ///< of the cones around the normals; infinite where there is none

  /// Empties all lanes.
  void clear();
  /// Empties a lane.
  void remove(int lane) { radius[lane] = -std::numeric_limits<float>::infinity(); }
  void copy(int to, const Discs& from, int lane);
};

/// Where positions are in relation to discs.
struct DiscPosition
{
  Float8 height;   ///< distance from the centre along the axis
  Float8 fromAxis; ///< distance from the axis

  /// @param offset of the positions from the centres.
  MEDIAL_INLINE DiscPosition(const std::array<Float8, 3>& offset,
    const std::array<Float8, 3>& normal)
  {
    const Float8 along = offset[0] * normal[0] + offset[1] * normal[1] + offset[2] * normal[2];
    Float8 squaredFromAxis{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const Float8 across = offset[axis] - along * normal[axis];
      squaredFromAxis += across * across;
    }
    height = max(along, -along);
    fromAxis = squareRoot(squaredFromAxis);
  }

  /// Of one position in relation to all discs.
  MEDIAL_INLINE DiscPosition(const Discs& discs, const glm::vec3& x)
    : DiscPosition({ x.x - loaded(discs.centre[0].data()), x.y - loaded(discs.centre[1].data()),
                     x.z - loaded(discs.centre[2].data()) },
        { loaded(discs.normal[0].data()), loaded(discs.normal[1].data()),
          loaded(discs.normal[2].data()) })
  {
  }

  MEDIAL_INLINE Float8 squaredDistance(Float8 radius, Float8 halfHeight) const
  {
    const Float8 h = max(height - halfHeight, Float8{});
    const Float8 q = max(fromAxis - radius, Float8{});
    return h * h + q * q;
  }
  MEDIAL_INLINE Float8 squaredDistance(const Discs& discs) const
  {
    return this->squaredDistance(loaded(discs.radius.data()), loaded(discs.halfHeight.data()));
  }

  /// Whether Voronoi regions of the discs may come within a distance of the position.
  MEDIAL_INLINE Int8 meetsRegions(const Discs& discs, float within) const
  {
    const Float8 along = height + loaded(discs.halfHeight.data()) + within;
    return fromAxis <= loaded(discs.radius.data()) + within + along * loaded(discs.slope.data());
  }
};

} // namespace medial

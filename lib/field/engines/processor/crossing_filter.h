#pragma once

#include "base/simd.h"
#include "field/crossing.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Rules out grid edges that the axis does not cross, eight at a time, in single precision. Few of
/// those where the closest site changes are left for double precision.
class CrossingFilter
{
public:
  /// Eight grid edges, side by side.
  struct alignas(32) Edges
  {
    std::array<std::array<float, kLanes>, 3> from; ///< first ends, local coordinates
    std::array<std::int32_t, kLanes> axis;         ///< along which they lead
    std::array<std::int32_t, kLanes> siteA;        ///< closest site at the first end
    std::array<std::int32_t, kLanes> siteB;        ///< and at the other
  };

  /// Uses the threads of the current arena.
  /// @param slack bound of the rounding of single precision near the grid and the mesh, local
  /// units.
  CrossingFilter(const CrossingSelection& selection, const SiteSet& sites, const GridFrame& frame,
    float slack);

  /// Returns which edges may be crossed, as bits: all that are, and some more.
  unsigned mayBeCrossed(const Edges& edges) const;

private:
  /// The displacement from x to the closest point of a site: with v = start - x it is
  /// whole * v + part * dot(v, direction) * direction.
  struct alignas(32) Displacement
  {
    float start[3];
    float whole;
    float direction[3];
    float part;
  };

  Displacement displacementOf(const SiteSet& sites, int site) const;

  float cosineLimit_;
  float slack_;
  std::array<float, 3> step_;
  std::vector<Displacement> displacements_; ///< for each site
};

} // namespace medial

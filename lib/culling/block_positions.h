#pragma once

#include "base/simd.h"
#include "culling/site_group.h"

#include <glm/glm.hpp>

#include <array>

namespace medial
{

/// The positions of a block of questions, eight side by side, each with the distance of a known
/// point.
class BlockPositions
{
public:
  static constexpr int kPacks = 4;
  static constexpr int kMax = kPacks * kLanes;

  /// The sites of one element that can be closest to positions.
  struct Near
  {
    int element;               ///< lane in its group
    int first;                 ///< the first of eight positions
    unsigned positions;        ///< which of the eight, as bits
    SiteGroup::IntLanes parts; ///< sites for each of these, as bits of SitePart
  };
  using NearList = std::array<Near, kPacks * SiteGroup::kSize>;

  void clear();
  /// @param x relative to the centre of the block.
  /// @param known distance of a surface point, rounded up.
  void add(const glm::vec3& x, float known);

  /// Finds the sites of a group that can be closest to the positions.
  /// @param elements to look at, as bits.
  /// @param shift from the centre of the block to the group's origin.
  /// @param slack by how much Voronoi regions are widened, besides the rounding.
  /// @return number of those found.
  int find(const SiteGroup& group, unsigned elements, const glm::vec3& shift, float slack,
    NearList& found) const;

private:
  int size_ = 0;
  float farthest_ = 0.0f; ///< of a position from the centre
  alignas(32) std::array<SiteGroup::Lanes3, kPacks> x_;
  alignas(
    32) std::array<SiteGroup::Lanes, kPacks> known_; ///< not a number in lanes without a position
};

} // namespace medial

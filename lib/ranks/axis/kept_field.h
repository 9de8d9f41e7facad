#pragma once

#include "medial/grid.h"
#include "medial/ranks.h"
#include "medial/side.h"
#include "ranks/axis/corner_numbers.h"
#include "ranks/axis/rank_part.h"
#include "ranks/axis/shared_bodies.h"
#include "ranks/field/field_part.h"
#include "thinning/sparse_blocks.h"
#include "thinning/voxel_solid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// The field at a grid point.
struct FieldValue
{
  float distance;    ///< world units
  std::int32_t site; ///< number in the whole surface
};

/// The field that ranks thin. It stays where they have computed it, since only little of it is
/// needed where they make the axis (AskedField).
class KeptField
{
public:
  /// Every rank calls it.
  /// @param part where this rank has computed the field, with what can be closest there; must
  ///   outlive this.
  /// @param values there.
  /// @param side that is looked at; Both without a sign.
  KeptField(Communicator& communicator, const RankPart& part, const Grid& grid, FieldPart values,
    Side side);

  const CornerNumbers& numbers() const { return numbers_; }
  /// Where this rank has computed the field.
  const RankPart& part() const { return part_; }
  /// That, and a layer around: what depth() is of.
  const Extent& extent() const { return extent_; }
  /// Number of solids on a side: bodies that only seem to touch have different colours.
  int colours(Side side) const
  {
    return side == Side::Interior && bodies_ ? bodies_->colours() : 1;
  }
  /// @param colour below colours(side).
  DepthField depth(Side side, int colour) const;

  /// Returns the colours of the sites that are here now, of the inside; nothing if there is one.
  /// Every rank calls it.
  std::vector<int> siteColours() const;
  /// Returns the field at points of the grid, from the ranks that have it. Every rank calls it.
  /// @param points as CornerNumbers, ascending.
  std::vector<FieldValue> at(const std::vector<std::int64_t>& points) const;

private:
  using SiteBlock = std::array<std::int32_t, kBlockLength>;

  void keep(FieldPart values);
  std::vector<std::int32_t> findBodies(const FieldPart& values);
  void setColours(const Extent& inner, const std::vector<std::int32_t>& colours);
  std::vector<FieldValue> valuesIn(std::int64_t block, std::uint64_t points) const;

  Communicator& communicator_;
  const RankPart& part_;
  CornerNumbers numbers_;
  Extent extent_;
  std::vector<float> distances_;
  SparseBlocks<SiteBlock> sites_;      ///< of most points of the grid there is none
  std::optional<SharedBodies> bodies_; ///< where the inside is thinned
  ///@{
  /// Where there are several: colours of points on the inside, and all there are.
  std::vector<std::int32_t> pointColours_;
  std::vector<int> allColours_;
  ///@}
};

} // namespace medial

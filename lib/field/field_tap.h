#pragma once

#include "base/huge_pages.h"
#include "medial/distance_field.h"
#include "medial/side.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace medial
{

/// The distance of points that are left out where one side is wanted: it says that they are on the
/// other.
inline float unknownDistance(Side side)
{
  return side == Side::Exterior ? -1.0f : 0.0f;
}

/// Keeps the distances and closest sites of a whole extent while a field goes to another sink.
/// Takes 8 bytes per point.
class FieldTap : public FieldSink
{
public:
  /// Values are kept at points that are at most so many steps away, along each axis, from one of
  /// the side. Engines may leave out others.
  static constexpr int kMargin = 1;

  /// @param side whose values are kept.
  FieldTap(FieldSink& sink, const Extent& extent, Side side)
    : sink_(sink)
    , extent_(extent)
    , distances_(static_cast<std::size_t>(extent.pointCount()))
    , sites_(distances_.size())
  {
    if (unknownDistance(side) != 0.0f)
    {
      std::fill(distances_.begin(), distances_.end(), unknownDistance(side));
    }
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    theirs_ = sink_.slabArrays(slab);
    FieldArrays arrays = theirs_;
    if (arrays.distance == nullptr)
    {
      arrays.distance = distances_.data() + this->start(slab);
    }
    if (arrays.closestSite == nullptr)
    {
      arrays.closestSite = sites_.data() + this->start(slab);
    }
    return arrays;
  }

  void stored(const Extent& slab) override
  {
    if (theirs_.distance != nullptr)
    {
      std::copy_n(theirs_.distance, slab.pointCount(), distances_.data() + this->start(slab));
    }
    if (theirs_.closestSite != nullptr)
    {
      std::copy_n(theirs_.closestSite, slab.pointCount(), sites_.data() + this->start(slab));
    }
    sink_.stored(slab);
  }

  std::size_t bytesPerPoint() const override { return sink_.bytesPerPoint(); }

  /// Whether the other sink wants no array, so that the values of the side are enough.
  bool sideOnly() const { return !theirs_.any(); }

  /// Signed as those of the sink; where points are left out, they are on the other side.
  const ZeroedVector<float>& distances() const { return distances_; }
  const ZeroedVector<std::int32_t>& sites() const { return sites_; }

private:
  std::ptrdiff_t start(const Extent& slab) const
  {
    return static_cast<std::ptrdiff_t>(slab.min[2] - extent_.min[2]) * extent_.size(0) *
      extent_.size(1);
  }

  FieldSink& sink_;
  Extent extent_;
  ZeroedVector<float> distances_;
  ZeroedVector<std::int32_t> sites_;
  FieldArrays theirs_;
};

} // namespace medial

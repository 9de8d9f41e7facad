#pragma once

#include "medial/distance_field.h"

#include <cstddef>

namespace medial
{

/// Writes slabs straight to arrays that hold a whole extent.
class ArraySink : public FieldSink
{
public:
  ArraySink(const Extent& extent, const FieldArrays& arrays)
    : extent_(extent)
    , arrays_(arrays)
  {
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    const std::ptrdiff_t start =
      static_cast<std::ptrdiff_t>(slab.min[2] - extent_.min[2]) * extent_.size(0) * extent_.size(1);
    FieldArrays arrays = arrays_;
    const auto advance = [](auto*& array, std::ptrdiff_t by)
    { array = array != nullptr ? array + by : nullptr; };
    advance(arrays.distance, start);
    advance(arrays.closestPoint, 3 * start);
    advance(arrays.closestSite, start);
    advance(arrays.closestFeature, start);
    advance(arrays.closestCell, start);
    return arrays;
  }

  void stored(const Extent& /*slab*/) override {}
  std::size_t bytesPerPoint() const override { return 0; }

private:
  Extent extent_;
  FieldArrays arrays_;
};

} // namespace medial

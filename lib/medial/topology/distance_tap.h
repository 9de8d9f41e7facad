#pragma once

#include "medial/distance/distance_field.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace medial
{

/// Keeps the distances of a whole extent while a field goes to another sink: 4 bytes a point.
class DistanceTap : public FieldSink
{
public:
  DistanceTap(FieldSink& sink, const Extent& extent)
    : sink_(sink)
    , extent_(extent)
    , distances_(static_cast<std::size_t>(extent.pointCount()))
  {
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    FieldArrays arrays = sink_.slabArrays(slab);
    theirs_ = arrays.distance;
    if (theirs_ == nullptr)
    {
      arrays.distance = this->ours(slab);
    }
    return arrays;
  }

  void stored(const Extent& slab) override
  {
    if (theirs_ != nullptr)
    {
      std::copy_n(theirs_, slab.pointCount(), this->ours(slab));
    }
    sink_.stored(slab);
  }

  std::size_t bytesPerPoint() const override { return sink_.bytesPerPoint(); }

  const std::vector<float>& distances() const { return distances_; }

private:
  float* ours(const Extent& slab)
  {
    return distances_.data() +
      static_cast<std::ptrdiff_t>(slab.min[2] - extent_.min[2]) * extent_.size(0) * extent_.size(1);
  }

  FieldSink& sink_;
  Extent extent_;
  std::vector<float> distances_;
  float* theirs_ = nullptr;
};

} // namespace medial

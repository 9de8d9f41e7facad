#include "field/engines/resumed_sink.h"

#include <algorithm>
#include <cstddef>

namespace medial
{
namespace
{

template <typename T>
T* resized(std::vector<T>& values, std::size_t count, bool wanted)
{
  values.resize(wanted ? count : 0);
  return wanted ? values.data() : nullptr;
}

} // namespace

FieldArrays ResumedSink::Scratch::resize(std::size_t points, const FieldArrays& wanted)
{
  return { resized(distance, points, wanted.distance != nullptr),
    resized(closestPoint, 3 * points, wanted.closestPoint != nullptr),
    resized(closestSite, points, wanted.closestSite != nullptr),
    resized(closestFeature, points, wanted.closestFeature != nullptr),
    resized(closestCell, points, wanted.closestCell != nullptr) };
}

ResumedSink::ResumedSink(const Extent& extent, FieldSink& sink)
  : sink_(sink)
  , next_(extent.min[2])
{
}

void ResumedSink::open(const Extent& slab)
{
  failed_ = true; // unless it returns
  openArrays_ = sink_.slabArrays(slab);
  failed_ = false;
  open_ = slab;
}

FieldArrays ResumedSink::slabArrays(const Extent& slab)
{
  passing_ = !open_ && slab.min[2] == next_;
  if (passing_)
  {
    this->open(slab);
    return openArrays_;
  }
  scratchArrays_ = scratch_.resize(static_cast<std::size_t>(slab.pointCount()), openArrays_);
  return scratchArrays_;
}

void ResumedSink::stored(const Extent& slab)
{
  const int first = passing_ ? slab.max[2] : std::max(slab.min[2], next_);
  for (int slice = first; slice <= slab.max[2]; ++slice)
  {
    if (!open_)
    {
      Extent rest = slab;
      rest.min[2] = slice;
      this->open(rest);
    }
    if (!passing_)
    {
      this->copySlice(slab, slice);
    }
    if (slice == open_->max[2])
    {
      const Extent full = *open_;
      open_.reset();
      next_ = slice + 1;
      failed_ = true; // unless it returns
      sink_.stored(full);
      failed_ = false;
    }
    else
    {
      next_ = slice + 1;
    }
  }
}

void ResumedSink::copySlice(const Extent& from, int slice)
{
  const std::ptrdiff_t points = std::ptrdiff_t{ from.size(0) } * from.size(1);
  const std::ptrdiff_t source = points * (slice - from.min[2]);
  const std::ptrdiff_t target = points * (slice - open_->min[2]);
  const auto copy = [&](const auto* values, auto* to, std::ptrdiff_t width)
  {
    if (to != nullptr)
    {
      std::copy_n(values + width * source, width * points, to + width * target);
    }
  };
  copy(scratchArrays_.distance, openArrays_.distance, 1);
  copy(scratchArrays_.closestPoint, openArrays_.closestPoint, 3);
  copy(scratchArrays_.closestSite, openArrays_.closestSite, 1);
  copy(scratchArrays_.closestFeature, openArrays_.closestFeature, 1);
  copy(scratchArrays_.closestCell, openArrays_.closestCell, 1);
}

} // namespace medial

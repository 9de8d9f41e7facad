#pragma once

#include "medial/distance_field.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace medial::test
{

struct SinkFailure : std::runtime_error
{
  SinkFailure()
    : std::runtime_error("the sink is full")
  {
  }
};

/// Collects slabs in the arrays of a whole extent.
class CollectingSink : public FieldSink
{
public:
  static constexpr float kUntouched = -12345.0f;

  CollectingSink(const Extent& extent, std::size_t bytesPerPoint)
    : bytesPerPoint_(bytesPerPoint)
    , sliceSize_(
        static_cast<std::size_t>(extent.size(0)) * static_cast<std::size_t>(extent.size(1)))
  {
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    EXPECT_FALSE(open_) << "two slabs at a time";
    open_ = true;
    slabs.push_back(slab);
    const auto count = static_cast<std::size_t>(slab.pointCount());
    distance_.assign(count, kUntouched);
    site_.assign(count, -1);
    FieldArrays arrays;
    arrays.distance = distance_.data();
    arrays.closestSite = site_.data();
    return arrays;
  }

  void stored(const Extent& slab) override
  {
    EXPECT_TRUE(open_);
    open_ = false;
    EXPECT_EQ(slab.min, slabs.back().min);
    EXPECT_EQ(slab.max, slabs.back().max);
    if (slabs.size() == failingSlab)
    {
      throw SinkFailure();
    }
    distance.insert(distance.end(), distance_.begin(), distance_.end());
    site.insert(site.end(), site_.begin(), site_.end());
  }

  std::size_t bytesPerPoint() const override { return bytesPerPoint_; }
  std::size_t sliceSize() const { return sliceSize_; }

  std::size_t failingSlab = 0; ///< counted from 1; 0 for none
  std::vector<Extent> slabs;
  std::vector<float> distance;
  std::vector<std::int32_t> site;

private:
  std::size_t bytesPerPoint_;
  std::size_t sliceSize_;
  bool open_ = false;
  std::vector<float> distance_;
  std::vector<std::int32_t> site_;
};

} // namespace medial::test

#include "thickness/depth_sink.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <utility>

namespace medial
{

DepthSink::DepthSink(const Grid& grid, Side side, FieldSink* sink, const Run& run, std::size_t kept)
  : grid_(grid)
  , sign_(side == Side::Interior ? -1.0f : 1.0f)
  , unit_(static_cast<float>(*std::min_element(grid.spacing.begin(), grid.spacing.end())))
  , sink_(sink)
  , run_(run)
  , kept_(kept)
{
}

FieldArrays DepthSink::slabArrays(const Extent& slab)
{
  FieldArrays arrays = sink_ != nullptr ? sink_->slabArrays(slab) : FieldArrays{};
  if (arrays.distance == nullptr)
  {
    own_.resize(static_cast<std::size_t>(slab.pointCount()));
    arrays.distance = own_.data();
  }
  distances_ = arrays.distance;
  return arrays;
}

void DepthSink::stored(const Extent& slab)
{
  const std::size_t points = static_cast<std::size_t>(slab.size(0)) * slab.size(1);
  std::vector<Slice> slices(slab.size(2));
  run_.onThreads(
    [&]
    {
      tbb::parallel_for(std::size_t{ 0 }, slices.size(),
        [&](std::size_t k)
        { slices[k] = this->sliceOf(slab.min[2] + static_cast<int>(k), distances_ + k * points); });
    });
  for (Slice& slice : slices)
  {
    max_ = std::max(max_, slice.max);
    border_.insert(border_.end(), slice.border.begin(), slice.border.end());
    if (kept_ > 0)
    {
      bytes_ += slice.rows.byteCount();
      rows_.push_back(std::move(slice.rows));
    }
  }
  if (bytes_ > kept_)
  {
    rows_ = {};
    kept_ = 0;
  }
  if (sink_ != nullptr)
  {
    sink_->stored(slab);
  }
}

std::size_t DepthSink::bytesPerPoint() const
{
  return sink_ != nullptr ? sink_->bytesPerPoint() : sizeof(float);
}

DepthSink::Slice DepthSink::sliceOf(int k, const float* distances) const
{
  const std::array<int, 3>& size = grid_.dimensions;
  Slice slice;
  std::vector<float> depths(kept_ > 0 ? size[0] : 0);
  for (int j = 0; j < size[1]; ++j, distances += size[0])
  {
    const bool border = k == 0 || k == size[2] - 1 || j == 0 || j == size[1] - 1;
    this->lookAtRow((static_cast<std::int64_t>(k) * size[1] + j) * size[0], distances, border,
      slice);
    if (kept_ > 0)
    {
      const float factor = sign_ / unit_;
      std::transform(distances, distances + size[0], depths.begin(),
        [factor](float distance) { return distance * factor; });
      slice.rows.add(depths.data(), depths.size());
    }
  }
  slice.rows.finish();
  return slice;
}

/// @param border whether the whole row is on the border, and not only its ends.
void DepthSink::lookAtRow(std::int64_t firstId, const float* distances, bool border,
  Slice& slice) const
{
  const int length = grid_.dimensions[0];
  float max = slice.max;
  for (int i = 0; i < length; ++i)
  {
    max = std::max(max, sign_ * distances[i]);
  }
  slice.max = max;
  for (int i = 0; i < length; i += border ? 1 : std::max(length - 1, 1))
  {
    if (sign_ * distances[i] > 0.0f)
    {
      slice.border.push_back({ firstId + i, sign_ * distances[i] });
    }
  }
}

void DepthSink::readDepths(const Extent& slab, float* distances) const
{
  const std::array<int, 3>& size = grid_.dimensions;
  const std::size_t rows = static_cast<std::size_t>(size[1]) * slab.size(2);
  tbb::parallel_for(std::size_t{ 0 }, rows,
    [&](std::size_t row)
    {
      std::vector<float> depths(size[0], 0.0f);
      rows_[slab.min[2] + row / size[1]].read(row % size[1], depths.data());
      float* const to = distances + row * size[0];
      for (int i = 0; i < size[0]; ++i)
      {
        to[i] = depths[i] > 0.0f ? depths[i] * sign_ * unit_ : to[i];
      }
    });
}

void DepthSink::addBorder(BallFamilies& families) const
{
  const std::array<int, 3>& size = grid_.dimensions;
  const std::array<std::int64_t, 3> strides{ 1, size[0],
    static_cast<std::int64_t>(size[0]) * size[1] };
  const auto first = static_cast<std::uint32_t>(families.size());
  for (std::uint32_t b = 0; b < border_.size(); ++b)
  {
    const std::int64_t id = border_[b].id;
    const std::array<int, 3> place{ static_cast<int>(id % size[0]),
      static_cast<int>(id / strides[1] % size[1]), static_cast<int>(id / strides[2]) };
    families.add(glm::vec3(place[0], place[1], place[2]) * families.step(),
      static_cast<float>(static_cast<double>(border_[b].depth) / families.unit()));
    families.join(first + b, first + b);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (place[axis] == size[axis] - 1)
      {
        continue;
      }
      const auto next = std::lower_bound(border_.begin(), border_.end(), id + strides[axis],
        [](const BorderPoint& point, std::int64_t wanted) { return point.id < wanted; });
      if (next != border_.end() && next->id == id + strides[axis])
      {
        families.join(first + b, first + static_cast<std::uint32_t>(next - border_.begin()));
      }
    }
  }
}

} // namespace medial

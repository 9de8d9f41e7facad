#include "thickness/depth_sink.h"

#include <algorithm>
#include <array>

namespace medial
{

DepthSink::DepthSink(const Grid& grid, Side side, FieldSink* sink)
  : grid_(grid)
  , sign_(side == Side::Interior ? -1.0f : 1.0f)
  , sink_(sink)
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
  const std::array<int, 3>& size = grid_.dimensions;
  const float* distances = distances_;
  for (int k = slab.min[2]; k <= slab.max[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j, distances += size[0])
    {
      const bool border = k == 0 || k == size[2] - 1 || j == 0 || j == size[1] - 1;
      this->lookAtRow((static_cast<std::int64_t>(k) * size[1] + j) * size[0], distances, border);
    }
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

/// @param border whether the whole row is on the border, and not only its ends.
void DepthSink::lookAtRow(std::int64_t firstId, const float* distances, bool border)
{
  const int length = grid_.dimensions[0];
  float max = max_;
  for (int i = 0; i < length; ++i)
  {
    max = std::max(max, sign_ * distances[i]);
  }
  max_ = max;
  for (int i = 0; i < length; i += border ? 1 : std::max(length - 1, 1))
  {
    if (sign_ * distances[i] > 0.0f)
    {
      border_.push_back({ firstId + i, sign_ * distances[i] });
    }
  }
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

#include "culling/block_positions.h"

#include "culling/nearest_site.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace medial
{
namespace
{

/// As OneElement, in one instruction: splat() adds to zero first.
struct SameElement
{
  int lane;

  MEDIAL_INLINE Float8 operator()(const SiteGroup::Lanes& lanes) const
  {
    const float v = lanes[lane];
    return Float8{ v, v, v, v, v, v, v, v };
  }
  MEDIAL_INLINE Int8 operator()(const SiteGroup::IntLanes& lanes) const
  {
    return Int8{} + lanes[lane];
  }
};

/// The box around an element in its plane. It begins at A: as AB is the longest edge, C is over AB.
struct PlaneBox
{
  Float8 length; ///< along x
  Float8 top;    ///< along y

  MEDIAL_INLINE PlaneBox(const SiteGroup& group, const SameElement& of)
    : length(of(group.lengths[0]))
    , top(of(group.lengths[2]) * of(group.fromA[1]))
  {
  }

  MEDIAL_INLINE Float8 squaredDistance(const PlanePosition& p) const
  {
    const Float8 x = max(max(-p.x, p.x - length), Float8{});
    const Float8 y = max(max(-p.y, p.y - top), Float8{});
    return p.height * p.height + x * x + y * y;
  }
};

} // namespace

void BlockPositions::clear()
{
  size_ = 0;
  farthest_ = 0.0f;
}

void BlockPositions::add(const glm::vec3& x, float known)
{
  const int pack = size_ / kLanes;
  const int lane = size_ % kLanes;
  if (lane == 0)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      x_[pack][axis].fill(x[axis]);
    }
    known_[pack].fill(std::numeric_limits<float>::quiet_NaN());
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    x_[pack][axis][lane] = x[axis];
  }
  known_[pack][lane] = known;
  farthest_ = std::max(farthest_, glm::length(x));
  ++size_;
}

MEDIAL_VECTORISED int BlockPositions::find(const SiteGroup& group, unsigned elements,
  const glm::vec3& shift, float slack, NearList& found) const
{
  const float rounding = roundingWithin(farthest_ + glm::length(shift) + group.extent);
  const int packs = (size_ + kLanes - 1) / kLanes;
  int count = 0;
  for (; elements != 0; elements &= elements - 1)
  {
    const SameElement of{ __builtin_ctz(elements) };
    const PlaneBox box(group, of);
    const glm::vec3 a(group.start[0][of.lane] + shift.x, group.start[1][of.lane] + shift.y,
      group.start[2][of.lane] + shift.z);
    for (int pack = 0; pack < packs; ++pack)
    {
      const SiteGroup::Lanes3& x = x_[pack];
      const Float8 reach = loaded(known_[pack].data()) + rounding;
      const Float8 limit = reach * reach;
      const PlanePosition plane(group, of,
        { loaded(x[0].data()) - a.x, loaded(x[1].data()) - a.y, loaded(x[2].data()) - a.z });
      if (bits(box.squaredDistance(plane) <= limit) == 0)
      {
        continue;
      }
      const ElementPosition position(group, of, plane);
      const Int8 within = position.squared <= limit;
      if (bits(within) == 0)
      {
        continue;
      }
      const Int8 sites = partsNear(group, of, position, slack + rounding) & within;
      found[count].element = of.lane;
      found[count].first = pack * kLanes;
      found[count].positions = bits(sites != 0);
      std::memcpy(found[count].parts.data(), &sites, sizeof(sites));
      count += found[count].positions != 0 ? 1 : 0;
    }
  }
  return count;
}

} // namespace medial

#pragma once

#include "culling/group_list.h"

#include <algorithm>

namespace medial
{

/// Squared distances times this are larger, however single precision rounds them.
constexpr float kRoundedUp = 1.0f + 1e-4f;

/// Returns the squared distance of discs up to which they may hold a nearer element. Lanes without
/// a disc are farther.
MEDIAL_INLINE float limitOf(const NearestElement& nearest)
{
  return std::min(nearest.squared * kRoundedUp, std::numeric_limits<float>::max());
}

/// As NearestElement::tryGroup().
MEDIAL_INLINE void tryElements(const std::vector<SiteGroup>& groups, int group, const glm::dvec3& x,
  NearestElement& nearest)
{
  const SiteGroup& tried = groups[group];
  ++nearest.tried;
  const Float8 squared = ElementPosition(tried, tried.toGroup(x)).squared;
  for (unsigned left = bits(squared <= nearest.squared); left != 0; left &= left - 1)
  {
    const int lane = __builtin_ctz(left);
    const bool lower = squared[lane] == nearest.squared && nearest.group >= 0 &&
      tried.elements[lane] < groups[nearest.group].elements[nearest.lane];
    if (squared[lane] < nearest.squared || lower)
    {
      nearest = { squared[lane], group, lane, nearest.tried };
    }
  }
}

} // namespace medial

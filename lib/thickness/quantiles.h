#pragma once

#include "base/order_statistics.h"
#include "medial/thickness.h"

#include <cstdint>
#include <limits>

namespace medial
{

/// Sets the smallest and the largest value of a thickness, and what is between; NaN if no point has
/// a value. The numbers of points are known.
/// @param at returns the value with an index in ascending order.
template <typename At>
void setQuantiles(Thickness& thickness, const At& at)
{
  thickness.min = thickness.percentile5 = thickness.median = thickness.percentile95 =
    thickness.max = std::numeric_limits<double>::quiet_NaN();
  const std::int64_t count = thickness.points - thickness.without;
  if (count > 0)
  {
    thickness.min = at(0);
    thickness.percentile5 = at(indexAfter(0.05, count));
    thickness.median = at(count / 2);
    thickness.percentile95 = at(indexBefore(0.05, count));
    thickness.max = at(count - 1);
  }
}

} // namespace medial

#include "culling/element_order.h"

#include "base/longest_axis.h"
#include "culling/site_group.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace medial
{

std::ptrdiff_t firstHalf(std::ptrdiff_t count)
{
  std::ptrdiff_t half = SiteGroup::kSize;
  while (2 * half < count)
  {
    half *= 2;
  }
  return half;
}

void sortByHalves(ElementPlace* begin, ElementPlace* end)
{
  const std::ptrdiff_t count = end - begin;
  if (count <= SiteGroup::kSize)
  {
    return;
  }
  glm::vec3 low(std::numeric_limits<float>::max());
  glm::vec3 high(std::numeric_limits<float>::lowest());
  for (const ElementPlace* place = begin; place != end; ++place)
  {
    low = glm::min(low, place->centre);
    high = glm::max(high, place->centre);
  }
  const int axis = longestAxis(glm::dvec3(high - low));
  ElementPlace* const middle = begin + firstHalf(count);
  // Of equal centres the lower site comes first, so that the halves do not depend on the order in
  // which places come.
  std::nth_element(begin, middle, end,
    [axis](const ElementPlace& a, const ElementPlace& b)
    { return std::pair(a.centre[axis], a.site) < std::pair(b.centre[axis], b.site); });
  constexpr std::ptrdiff_t kAlone = 4096;
  if (count < kAlone)
  {
    sortByHalves(begin, middle);
    sortByHalves(middle, end);
    return;
  }
  ElementPlace* const ends[3] = { begin, middle, end };
  tbb::parallel_for(0, 2, [&](int i) { sortByHalves(ends[i], ends[i + 1]); });
}

int SizeClasses::of(float radius) const
{
  const bool larger = radius > limit_ && limit_ > 0.0f;
  return larger ? 1 + static_cast<int>(std::log2(radius / limit_) / 3.0f) : 0;
}

} // namespace medial

#include "culling/discs.h"

#include <limits>

namespace medial
{

void Discs::clear()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    centre[axis].fill(0.0f);
    normal[axis].fill(0.0f);
  }
  radius.fill(-std::numeric_limits<float>::infinity());
  halfHeight.fill(0.0f);
  slope.fill(0.0f);
}

void Discs::copy(int to, const Discs& from, int lane)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    centre[axis][to] = from.centre[axis][lane];
    normal[axis][to] = from.normal[axis][lane];
  }
  radius[to] = from.radius[lane];
  halfHeight[to] = from.halfHeight[lane];
  slope[to] = from.slope[lane];
}

} // namespace medial

#include "base/extents.h"
#include "base/range_check.h"
#include "medial/error.h"
#include "medial/ranks.h"

#include <algorithm>
#include <string>

namespace medial
{
namespace
{

/// Grid points along an edge of the parts that are computed in one go.
constexpr int kStep = 16;

/// Cuts an extent in two where its halves have about as many points for each of their parts.
void cut(const Extent& extent, int parts, std::vector<Extent>& found)
{
  if (parts == 1)
  {
    found.push_back(extent);
    return;
  }
  int axis = 2;
  for (const int other : { 1, 0 })
  {
    axis = extent.size(other) > extent.size(axis) ? other : axis;
  }
  const int low = parts / 2;
  const int steps = (extent.size(axis) + kStep - 1) / kStep;
  const int first = std::min((steps * low + parts / 2) / parts, steps);
  Extent lower = extent;
  Extent upper = extent;
  lower.max[axis] = std::min(extent.min[axis] + first * kStep - 1, extent.max[axis]);
  upper.min[axis] = lower.max[axis] + 1;
  cut(lower, low, found);
  cut(upper, parts - low, found);
}

} // namespace

std::vector<Extent> partsOfGrid(const Grid& grid, int parts)
{
  validateGrid(grid);
  if (parts < 1)
  {
    throwOutside("number of parts", parts, "[1, infinity)");
  }
  std::vector<Extent> found;
  cut(grid.wholeExtent(), parts, found);
  for (Extent& extent : found)
  {
    extent = extent.empty() ? Extent{} : extent;
  }
  return found;
}

Extent touchingExtent(const Grid& grid, const Extent& extent)
{
  return grownUpwards(extent, 1, grid.wholeExtent());
}

} // namespace medial

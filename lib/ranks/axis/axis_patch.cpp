#include "ranks/axis/axis_patch.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace medial
{

AxisPatch::AxisPatch(Communicator& communicator, const std::vector<MovedCorner>& corners,
  const std::vector<NumberedCorners>& cells)
{
  std::vector<MovedCorner> points = atFirst(communicator, corners);
  std::vector<NumberedCorners> numbered = atFirst(communicator, cells);
  std::sort(points.begin(), points.end(),
    [](const MovedCorner& a, const MovedCorner& b) { return a.number < b.number; });
  points.erase(std::unique(points.begin(), points.end(),
                 [](const MovedCorner& a, const MovedCorner& b) { return a.number == b.number; }),
    points.end());
  for (const MovedCorner& point : points)
  {
    numbers.push_back(point.number);
    before.push_back(point.before);
    axis.points.points.push_back(point.after);
  }
  // All cells with the same first point come from one rank, which has them in their order.
  std::stable_sort(numbered.begin(), numbered.end(),
    [](const NumberedCorners& a, const NumberedCorners& b) { return a[0] < b[0]; });
  const auto indexOf = [&](std::int64_t number)
  { return std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin(); };
  for (const auto& [a, b, c, d] : numbered)
  {
    if (c < 0)
    {
      axis.lines.push_back({ indexOf(a), indexOf(b) });
    }
    else
    {
      axis.quads.push_back({ indexOf(a), indexOf(b), indexOf(c), indexOf(d) });
    }
  }
}

} // namespace medial

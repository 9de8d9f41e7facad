#include "sign/inside_rows.h"

#include <algorithm>

namespace medial
{

InsideRows::InsideRows(const Extent& extent, const std::vector<SliceCrossings>& slices)
  : extent_(extent)
  , slices_(slices.size())
{
  for (std::size_t k = 0; k < slices.size(); ++k)
  {
    Slice& slice = slices_[k];
    auto next = slices[k].begin();
    for (int j = extent.min[1]; j <= extent.max[1]; ++j)
    {
      slice.offsets.push_back(static_cast<int>(slice.changes.size()));
      int winding = 0;
      while (next != slices[k].end() && next->row == j)
      {
        const bool before = winding >= 1;
        const int point = next->point;
        for (; next != slices[k].end() && next->row == j && next->point == point; ++next)
        {
          winding += next->change;
        }
        if ((winding >= 1) != before)
        {
          slice.changes.push_back(point);
        }
      }
    }
    slice.offsets.push_back(static_cast<int>(slice.changes.size()));
  }
}

InsideRows::Row InsideRows::row(int j, int k) const
{
  const Slice& slice = slices_[k - extent_.min[2]];
  const int* offset = &slice.offsets[j - extent_.min[1]];
  return { slice.changes.data() + offset[0], slice.changes.data() + offset[1] };
}

bool InsideRows::contains(const glm::ivec3& point) const
{
  const Row row = this->row(point.y, point.z);
  return (std::upper_bound(row.begin, row.end, point.x) - row.begin) % 2 != 0;
}

void InsideRows::write(const glm::ivec3& first, int count, float* sides) const
{
  this->visitRuns(first, count,
    [&](int begin, int end, bool inside)
    { std::fill(sides + begin, sides + end, inside ? -1.0f : 1.0f); });
}

} // namespace medial

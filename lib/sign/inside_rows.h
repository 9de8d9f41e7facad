#pragma once

#include "medial/grid.h"
#include "sign/row_crossings.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

namespace medial
{

/// Which grid points of an extent are inside a solid: for every row along x the points at which
/// this changes.
class InsideRows
{
public:
  /// @param slices changes of the winding number; points are inside where their sum is 1 or more.
  InsideRows(const Extent& extent, const std::vector<SliceCrossings>& slices);

  /// Whether a grid point of the extent is inside.
  bool contains(const glm::ivec3& point) const;
  /// Writes -1 for points that are inside and 1 for others.
  /// @param first grid point of a row, of which `count` points are written.
  void write(const glm::ivec3& first, int count, float* sides) const;

  /// Calls visit(begin, end, inside) for the runs of points inside and outside in a part of a row;
  /// begin and end count from its first point.
  /// @param first grid point of a row, of which `count` points are visited.
  template <typename Visit>
  void visitRuns(const glm::ivec3& first, int count, const Visit& visit) const
  {
    const Row row = this->row(first.y, first.z);
    const int* change = std::upper_bound(row.begin, row.end, first.x);
    bool inside = (change - row.begin) % 2 != 0;
    for (int begin = 0; begin < count; inside = !inside)
    {
      const int end = change == row.end ? count : std::min(count, *change++ - first.x);
      visit(begin, end, inside);
      begin = end;
    }
  }

  /// Calls visit(point, change) for every grid point of some slices at which a row enters (1) or
  /// leaves (-1) the solid; rows that begin inside enter at their first point.
  template <typename Visit>
  void visitChanges(int firstSlice, int lastSlice, const Visit& visit) const
  {
    for (int k = firstSlice; k <= lastSlice; ++k)
    {
      for (int j = extent_.min[1]; j <= extent_.max[1]; ++j)
      {
        const Row row = this->row(j, k);
        for (const int* change = row.begin; change != row.end && *change <= extent_.max[0];
             ++change)
        {
          visit(glm::ivec3(*change, j, k), (change - row.begin) % 2 == 0 ? 1 : -1);
        }
      }
    }
  }

private:
  struct Slice
  {
    std::vector<int> offsets; ///< per row, and the end
    std::vector<int> changes; ///< ascending in a row
  };
  struct Row
  {
    const int* begin;
    const int* end;
  };

  Row row(int j, int k) const;

  Extent extent_;
  std::vector<Slice> slices_;
};

} // namespace medial

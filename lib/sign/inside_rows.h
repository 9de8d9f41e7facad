#pragma once

#include "medial/grid.h"
#include "sign/row_crossings.h"

#include <glm/glm.hpp>

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

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

#pragma once

#include "medial/grid.h"
#include "medial/side.h"
#include "sign/inside_rows.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Which parts of a grid, cubes of some size, have points on one side of the surface or next to it.
class SideParts
{
public:
  /// Uses the threads of the current arena.
  /// @param extent the points that count.
  /// @param whole all of the grid; parts start at multiples of the size from its corner.
  /// @param size number of grid points along an edge of a part.
  /// @param margin points that are at most so many steps away from one of the side along each axis
  ///   belong to it. The rows must have the extent with this margin, as far as the grid goes.
  SideParts(const InsideRows& inside, Side side, const Extent& extent, const Extent& whole,
    int size, int margin = 0);

  /// Whether an extent, made of whole parts, has points that count and are on the side.
  bool meets(const Extent& parts) const;

private:
  /// Index of the part with a coordinate of a grid point, counted from the first part.
  int partAt(int axis, int coordinate) const
  {
    return (coordinate - whole_.min[axis]) / size_ - first_[axis];
  }
  void markLayer(const InsideRows& inside, Side side, const Extent& points, int layer);
  void markRun(int first, int last, int j, int layer);

  Extent extent_;
  Extent whole_;
  int size_;
  int margin_;
  std::array<int, 3> first_; ///< the first part, counted from the corner of the grid
  std::array<int, 3> count_;
  std::vector<std::uint8_t> marks_; ///< for each part, x fastest
};

} // namespace medial

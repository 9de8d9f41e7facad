#pragma once

#include "thinning/cubical_complex.h"
#include "thinning/voxel_surface.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace medial
{

/// Sheets, as voxels see them.
class SheetCells
{
public:
  explicit SheetCells(const CubicalComplex& sheets)
    : sheets_(sheets)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      corners_[corner] = static_cast<std::size_t>(
        (corner & 1) + (corner >> 1 & 1) * sheets.stride(1) + (corner >> 2) * sheets.stride(2));
    }
  }

  /// Returns the cells that a voxel shares with the sheets.
  SurfaceCells sharedWith(std::size_t voxel) const
  {
    SurfaceCells cells = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const std::uint8_t bits = sheets_.bits(voxel + corners_[corner]);
      cells |= bits != 0 ? atCorners_.at(corner, bits) : 0;
    }
    return cells;
  }

private:
  const CubicalComplex& sheets_;
  std::array<std::size_t, 8> corners_{};
  const CellsAtCorners& atCorners_ = cellsAtCorners();
};

} // namespace medial

#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

namespace medial
{

/// How the slices of a slab lie side by side in one 2D texture. Slot 0 holds the last slice of the
/// previous slab, since the selection compares neighbouring slices; the slab starts at slot 1.
struct AtlasLayout
{
  glm::ivec2 sliceSize{ 0 }; ///< grid points of a slice
  int columns = 1;
  int rows = 1;
  int slabSlices = 0; ///< slices of a full slab

  /// Whether a slab of `slabSlices` slices of the extent fits into square textures of
  /// `textureLimit` pixels.
  static bool fits(const Extent& extent, int slabSlices, int textureLimit);

  /// Makes a nearly square layout.
  /// @throws Error GpuLimit if it does not fit.
  static AtlasLayout make(const Extent& extent, int slabSlices, int textureLimit);

  bool operator==(const AtlasLayout& other) const
  {
    return sliceSize == other.sliceSize && columns == other.columns && rows == other.rows &&
      slabSlices == other.slabSlices;
  }

  glm::ivec2 size() const { return { columns * sliceSize.x, rows * sliceSize.y }; }
  glm::ivec2 slotOrigin(int slot) const
  {
    return { slot % columns * sliceSize.x, slot / columns * sliceSize.y };
  }
};

} // namespace medial

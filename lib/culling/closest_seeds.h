#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The sites that were closest amid tiles of the grid in an earlier frame. Wherever the mesh has
/// moved since, their distances are upper bounds of the field, and tight ones if it moved little.
class ClosestSeeds
{
public:
  /// Grid points along the sides of a tile.
  static constexpr int kTileSize = 8;

  /// Forgets all, and gets ready for the tiles of an extent.
  void reset(const Extent& extent);

  /// Whether anything is known about tiles of this extent.
  bool knows(const Extent& extent) const;

  /// Notes the closest site amid a tile. May be called from several threads for different tiles.
  void set(const Extent& tile, int site);

  /// The site noted for the tile amid `node`; -1 if none.
  int at(const Extent& node) const { return sites_[this->indexOf(node)]; }

private:
  std::size_t indexOf(const Extent& node) const;

  Extent extent_;
  glm::ivec3 counts_{ 0 };
  std::vector<int> sites_; ///< x fastest
};

} // namespace medial

#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// The sites that were closest in the middle of tiles in an earlier frame. Wherever the mesh has
/// moved since, their distances are upper bounds of the field, and tight ones if it has moved
/// little.
class ClosestSeeds
{
public:
  /// Number of grid points along an edge of a tile.
  static constexpr int kTileSize = 8;

  /// Forgets all seeds and prepares for the tiles of an extent.
  void reset(const Extent& extent);

  /// Whether there are seeds for the tiles of this extent.
  bool knows(const Extent& extent) const;

  /// Stores the closest site in the middle of a tile. Several threads may call it at once for
  /// different tiles.
  void set(const Extent& tile, int site);

  /// Returns the site of the tile in the middle of `node`; -1 if there is none.
  int at(const Extent& node) const { return sites_[this->indexOf(node)]; }

private:
  std::size_t indexOf(const Extent& node) const;

  Extent extent_;
  glm::ivec3 counts_{ 0 };
  std::vector<int> sites_; ///< x fastest
};

} // namespace medial

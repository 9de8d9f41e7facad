#pragma once

#include "medial/export.h"

#include <cstdint>

namespace medial
{

/// What every homotopy preserves in a solid or in the cells of an axis.
struct CellTopology
{
  std::int64_t components = 0;          ///< pieces
  std::int64_t eulerCharacteristic = 0; ///< components - genus + cavities
  /// Tunnels: independent loops that bound nothing. For a solid, the sum of the genera of its
  /// boundary surfaces.
  std::int64_t genus = 0;
  std::int64_t cavities = 0; ///< hollows without a way out

  /// Whether all four numbers are equal.
  bool operator==(const CellTopology& other) const
  {
    return components == other.components && eulerCharacteristic == other.eulerCharacteristic &&
      genus == other.genus && cavities == other.cavities;
  }
  /// Whether any number differs.
  bool operator!=(const CellTopology& other) const { return !(*this == other); }
};

struct MedialAxis;

/// Returns the topology of the cells of an axis as they are stored: points are equal if their ids
/// are; the edges are the lines and the pairs of consecutive corners of quads and triangles. The
/// time is linear, except that cavities need rank computations over the seams of closed sheets.
MEDIAL_EXPORT CellTopology topologyOf(const MedialAxis& axis);

} // namespace medial

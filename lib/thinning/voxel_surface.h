#pragma once

#include "base/simd.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace medial
{

/// The 27 voxels around one, itself included, x fastest.
inline constexpr int kAround = 27;
inline constexpr int kCentre = 13;

inline glm::ivec3 offsetOf(int around)
{
  return { around % 3 - 1, around / 3 % 3 - 1, around / 9 - 1 };
}

/// Cells of the surface of a voxel, as bits: corners in the lowest byte, by x, y, z; then a byte
/// for the edges along each axis, by their lower corners; then the faces.
using SurfaceCells = std::uint64_t;

inline constexpr int kFirstEdges = 8;
inline constexpr int kFirstFaces = 32;

/// The cells that a voxel shares with any of some voxels around, looked up by nine of them at a
/// time.
class SharedCells
{
public:
  SharedCells();

  /// @param voxels bits of the voxels around.
  MEDIAL_INLINE SurfaceCells with(std::uint32_t voxels) const
  {
    return layers_[0][voxels & 511] | layers_[1][voxels >> 9 & 511] | layers_[2][voxels >> 18];
  }

private:
  std::array<std::array<SurfaceCells, 512>, 3> layers_{};
};

const SharedCells& sharedCells();

/// Cells of a voxel's surface, looked up by those that a complex has at its corners.
class CellsAtCorners
{
public:
  CellsAtCorners();

  /// @param bits of the complex at a corner.
  SurfaceCells at(int corner, std::uint8_t bits) const { return cells_[corner][bits]; }

private:
  std::array<std::array<SurfaceCells, 256>, 8> cells_{};
};

const CellsAtCorners& cellsAtCorners();

/// Returns the corners that are connected by edges with the given ones.
MEDIAL_INLINE unsigned connectedCorners(SurfaceCells cells, unsigned corners)
{
  const auto alongX = static_cast<unsigned>(cells >> kFirstEdges & 0xff);
  const auto alongY = static_cast<unsigned>(cells >> (kFirstEdges + 8) & 0xff);
  const auto alongZ = static_cast<unsigned>(cells >> (kFirstEdges + 16) & 0xff);
  unsigned before = 0;
  while (corners != before)
  {
    before = corners;
    corners |= (corners & alongX) << 1 | (corners >> 1 & alongX);
    corners |= (corners & alongY) << 2 | (corners >> 2 & alongY);
    corners |= (corners & alongZ) << 4 | (corners >> 4 & alongZ);
  }
  return corners;
}

/// Whether cells of a voxel's surface, with all their faces, are in one piece and without holes.
MEDIAL_INLINE bool contractible(SurfaceCells cells)
{
  constexpr SurfaceCells kEdges = 0xffffff00;
  const int eulerCharacteristic =
    __builtin_popcountll(cells & ~kEdges) - __builtin_popcountll(cells & kEdges);
  const auto corners = static_cast<unsigned>(cells & 0xff);
  return eulerCharacteristic == 1 && connectedCorners(cells, corners & (0u - corners)) == corners;
}

} // namespace medial

#pragma once

#include "medial/grid.h"
#include "thinning/sparse_blocks.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace medial
{

/// Voxels of a solid with their depths and a value for each, which are loaded where somebody looks.
/// Voxels are numbered by their grid points, x fastest, and blocks have kBlockLength in a row.
class SparseVoxels
{
public:
  /// Loads blocks by set().
  using Load = std::function<void(const std::vector<std::size_t>& blocks)>;
  /// @param size of the grid.
  SparseVoxels(const glm::ivec3& size, Load load);

  /// @param depths as DepthField::at(): those of points that belong to the side are not negative,
  ///   nor -0.
  void set(std::size_t block, const std::array<float, kBlockLength>& depths);

  /// Loads what is around voxels, at once instead of when somebody looks.
  /// @param reach along each axis.
  void loadAround(const std::vector<std::size_t>& voxels, int reach);

  /// Returns the depth of any grid point, as DepthField::at().
  float at(std::size_t voxel) { return this->block(voxel).depths[voxel % kBlockLength]; }
  float distance(std::size_t voxel) { return std::abs(this->at(voxel)); }
  /// The value of a voxel: when it is loaded 1 if it is in the solid, or 0.
  std::uint8_t value(std::size_t voxel) { return this->block(voxel).values[voxel % kBlockLength]; }
  void setValue(std::size_t voxel, std::uint8_t value)
  {
    this->block(voxel).values[voxel % kBlockLength] = value;
  }
  /// Returns the loaded voxels that have at least some value, ascending.
  std::vector<std::size_t> atLeast(std::uint8_t value) const;

private:
  struct Block
  {
    std::array<float, kBlockLength> depths{};
    std::array<std::uint8_t, kBlockLength> values{};
  };

  /// Where somebody looks, others are looked at next.
  static constexpr int kReach = 8;

  Block& block(std::size_t voxel)
  {
    const std::size_t number = voxel / kBlockLength;
    if (!blocks_.has(number))
    {
      this->loadAround(std::vector<std::size_t>{ voxel }, kReach);
    }
    return blocks_.make(number);
  }

  glm::ivec3 size_;
  Load load_;
  SparseBlocks<Block> blocks_;
};

} // namespace medial

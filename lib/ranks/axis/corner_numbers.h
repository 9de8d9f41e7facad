#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace medial
{

/// Numbers the positions of a grid, x fastest, once for each of several solids: in the order in
/// which one process makes the points of a preserved axis.
class CornerNumbers
{
public:
  explicit CornerNumbers(const Grid& grid)
    : size_(grid.dimensions[0], grid.dimensions[1], grid.dimensions[2])
    , count_(grid.pointCount())
  {
  }

  const glm::ivec3& size() const { return size_; }
  /// Number of positions.
  std::int64_t count() const { return count_; }
  std::int64_t of(const glm::ivec3& position, std::size_t solid = 0) const
  {
    return static_cast<std::int64_t>(solid) * count_ +
      (static_cast<std::int64_t>(position.z) * size_.y + position.y) * size_.x + position.x;
  }
  glm::ivec3 position(std::int64_t number) const
  {
    const std::int64_t place = number % count_;
    const std::int64_t row = place / size_.x;
    return { static_cast<int>(place % size_.x), static_cast<int>(row % size_.y),
      static_cast<int>(row / size_.y) };
  }
  /// Returns the grid cell around a corner.
  glm::ivec3 cell(std::int64_t number) const { return this->position(number) - 1; }

private:
  glm::ivec3 size_;
  std::int64_t count_;
};

/// What is left of a solid at a position of the grid.
class CornerCells
{
public:
  CornerCells() = default;
  /// @param position as CornerNumbers, of the first solid.
  /// @param bits one for each cell of the cubical complex there, as CubicalComplex.
  CornerCells(std::int64_t position, std::uint8_t bits)
    : packed_(kBits * position + bits)
  {
  }

  std::int64_t position() const { return packed_ / kBits; }
  std::uint8_t bits() const { return static_cast<std::uint8_t>(packed_ % kBits); }

private:
  static constexpr std::int64_t kBits = 256;
  std::int64_t packed_ = 0; ///< half of what two members would take
};

} // namespace medial

#pragma once

#include "base/huge_pages.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Blocks of values for a grid, of which most are as they are made. These take 4 bytes each, and
/// share one block.
/// @tparam Block made by its default constructor.
template <typename Block>
class SparseBlocks
{
public:
  /// @param count of the blocks.
  explicit SparseBlocks(std::size_t count)
    : numbers_(count)
    , blocks_(1)
  {
  }

  std::size_t count() const { return numbers_.size(); }
  /// Whether a block has memory of its own.
  bool has(std::size_t block) const { return numbers_[block] != 0; }
  const Block& operator[](std::size_t block) const { return blocks_[numbers_[block]]; }
  /// Returns a block to be changed. Threads may do so at once where blocks have memory.
  Block& make(std::size_t block)
  {
    std::uint32_t& number = numbers_[block];
    if (number == 0)
    {
      number = static_cast<std::uint32_t>(blocks_.size());
      blocks_.emplace_back();
    }
    return blocks_[number];
  }

private:
  ZeroedVector<std::uint32_t> numbers_; ///< 0 for those that are as they are made
  std::vector<Block> blocks_;           ///< the first is the one that they share
};

/// Positions in a row that a block of bytes has: as many as a cache line.
inline constexpr std::size_t kBlockLength = 64;

/// Returns how many blocks some positions have.
inline std::size_t blocksFor(std::size_t positions)
{
  return (positions + kBlockLength - 1) / kBlockLength;
}

} // namespace medial

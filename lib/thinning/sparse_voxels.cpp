#include "thinning/sparse_voxels.h"

#include "base/sorted_set.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{

/// What is loaded at once takes some memory more than once.
constexpr std::size_t kBlocksAtOnce = std::size_t{ 1 } << 16;
/// So many are looked through for those that are listed twice.
constexpr std::size_t kManyBlocks = std::size_t{ 1 } << 20;

} // namespace

SparseVoxels::SparseVoxels(const glm::ivec3& size, Load load)
  : size_(size)
  , load_(std::move(load))
  , blocks_(blocksFor(static_cast<std::size_t>(size.x) * size.y * size.z))
{
}

void SparseVoxels::set(std::size_t block, const std::array<float, kBlockLength>& depths)
{
  Block& here = blocks_.make(block);
  here.depths = depths;
  const std::size_t first = block * kBlockLength;
  glm::ivec3 point(static_cast<int>(first % size_.x), static_cast<int>(first / size_.x % size_.y),
    static_cast<int>(first / size_.x / size_.y));
  for (std::size_t i = 0; i < kBlockLength; ++i)
  {
    const bool inGrid =
      glm::all(glm::greaterThan(point, glm::ivec3(0))) && glm::all(glm::lessThan(point, size_ - 1));
    here.values[i] = inGrid && !std::signbit(depths[i]) ? 1 : 0;
    for (int axis = 0; axis < 3 && ++point[axis] == size_[axis] && axis < 2; ++axis)
    {
      point[axis] = 0;
    }
  }
}

void SparseVoxels::loadAround(const std::vector<std::size_t>& voxels, int reach)
{
  const std::ptrdiff_t row = size_.x;
  const std::ptrdiff_t layer = row * size_.y;
  const auto length = static_cast<std::ptrdiff_t>(kBlockLength);
  std::vector<std::size_t> blocks;
  std::pair<std::ptrdiff_t, std::ptrdiff_t> last(-1, -1);
  for (const std::size_t voxel : voxels)
  {
    const auto place = static_cast<std::ptrdiff_t>(voxel);
    const std::pair<std::ptrdiff_t, std::ptrdiff_t> ends((place - reach) / length,
      (place + reach) / length);
    if (ends == last) // as for most in a row
    {
      continue;
    }
    last = ends;
    if (blocks.size() >= kManyBlocks)
    {
      makeSet(blocks);
    }
    for (std::ptrdiff_t z = -reach; z <= reach; ++z)
    {
      for (std::ptrdiff_t y = -reach; y <= reach; ++y)
      {
        const std::ptrdiff_t there = place + z * layer + y * row;
        for (std::ptrdiff_t block = (there - reach) / length; block <= (there + reach) / length;
             ++block)
        {
          if (there >= reach && block < static_cast<std::ptrdiff_t>(blocks_.count()) &&
            !blocks_.has(static_cast<std::size_t>(block)))
          {
            blocks.push_back(static_cast<std::size_t>(block));
          }
        }
      }
    }
  }
  makeSet(blocks);
  for (std::size_t first = 0; first < blocks.size(); first += kBlocksAtOnce)
  {
    const auto begin = blocks.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(kBlocksAtOnce, blocks.size() - first);
    load_({ begin, begin + static_cast<std::ptrdiff_t>(count) });
  }
}

std::vector<std::size_t> SparseVoxels::atLeast(std::uint8_t value) const
{
  std::vector<std::size_t> voxels;
  for (std::size_t block = 0; block < blocks_.count(); ++block)
  {
    const Block& here = blocks_[block];
    for (std::size_t i = 0; i < kBlockLength && blocks_.has(block); ++i)
    {
      if (here.values[i] >= value)
      {
        voxels.push_back(block * kBlockLength + i);
      }
    }
  }
  return voxels;
}

} // namespace medial

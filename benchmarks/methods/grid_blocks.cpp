#include "methods/grid_blocks.h"

namespace medial::benchmark
{
namespace
{

constexpr int kBlockSize = 8;

/// Moves the low ten bits apart so that two others fit between each pair.
std::uint32_t spread(std::uint32_t bits)
{
  std::uint32_t result = 0;
  for (int bit = 0; bit < 10; ++bit)
  {
    result |= (bits >> bit & 1U) << (3 * bit);
  }
  return result;
}

std::uint32_t mortonCode(const Extent& block)
{
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    code |= spread(static_cast<std::uint32_t>(block.min[axis] / kBlockSize)) << axis;
  }
  return code;
}

} // namespace

std::vector<Extent> mortonBlocks(const Grid& grid)
{
  std::vector<Extent> blocks;
  for (int k = 0; k < grid.dimensions[2]; k += kBlockSize)
  {
    for (int j = 0; j < grid.dimensions[1]; j += kBlockSize)
    {
      for (int i = 0; i < grid.dimensions[0]; i += kBlockSize)
      {
        Extent block{ { i, j, k }, {} };
        for (int axis = 0; axis < 3; ++axis)
        {
          block.max[axis] = std::min(block.min[axis] + kBlockSize, grid.dimensions[axis]) - 1;
        }
        blocks.push_back(block);
      }
    }
  }
  std::sort(blocks.begin(), blocks.end(),
    [](const Extent& a, const Extent& b) { return mortonCode(a) < mortonCode(b); });
  return blocks;
}

} // namespace medial::benchmark

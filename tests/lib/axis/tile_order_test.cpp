#include "axis/tile_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace medial::test
{
namespace
{

TEST(TileOrder, HasEveryNumberOnceAndTilesTogether)
{
  Extent extent;
  extent.min = { -3, 5, 0 };
  extent.max = { 40, 37, 20 };
  std::vector<glm::ivec3> cells;
  for (int z = extent.min[2] - 1; z <= extent.max[2]; ++z)
  {
    for (int y = extent.min[1] - 1; y <= extent.max[1]; ++y)
    {
      for (int x = extent.min[0] - 1; x <= extent.max[0]; ++x)
      {
        cells.emplace_back(x, y, z);
      }
    }
  }
  std::vector<std::uint32_t> order =
    tileOrder(extent, cells.size(), [&](std::size_t i) { return cells[i]; });
  std::size_t far = 0;
  for (std::size_t k = 1; k < order.size(); ++k)
  {
    const glm::ivec3 step = glm::abs(cells[order[k]] - cells[order[k - 1]]);
    far += std::max({ step.x, step.y, step.z }) > 7 ? 1 : 0;
  }
  EXPECT_LT(far, order.size() / 100);
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    ASSERT_EQ(order[i], i);
  }
}

TEST(TileOrder, KeepsNeighboursTogetherWhereCellsAreRare)
{
  Extent extent;
  extent.max = { 255, 255, 255 };
  std::vector<glm::ivec3> cells; // one for each tile
  for (int z = 0; z < 32; ++z)
  {
    for (int y = 0; y < 32; ++y)
    {
      for (int x = 0; x < 32; ++x)
      {
        cells.emplace_back(8 * x, 8 * y, 8 * z);
      }
    }
  }
  const std::vector<std::uint32_t> order =
    tileOrder(extent, cells.size(), [&](std::size_t i) { return cells[i]; });
  constexpr std::size_t kInARow = 64;
  for (std::size_t begin = 0; begin < order.size(); begin += kInARow)
  {
    glm::ivec3 low = cells[order[begin]];
    glm::ivec3 high = low;
    for (std::size_t k = begin; k < begin + kInARow; ++k)
    {
      low = glm::min(low, cells[order[k]]);
      high = glm::max(high, cells[order[k]]);
    }
    const glm::ivec3 size = high - low;
    EXPECT_LE(std::max({ size.x, size.y, size.z }), 24) << begin;
  }
}

} // namespace
} // namespace medial::test

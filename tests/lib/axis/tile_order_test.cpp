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

} // namespace
} // namespace medial::test

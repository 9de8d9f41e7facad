#include "ranks/field/work_cut.h"

#include "base/extents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace medial;

namespace
{

const Extent kWhole{ { 0, 0, 0 }, { 95, 63, 40 } };

/// Cubes of four points along an edge.
template <typename WorkOf>
std::vector<WorkBox> boxesOf(const WorkOf& workOf)
{
  std::vector<WorkBox> boxes;
  visitParts(kWhole, 4,
    [&](const Extent& box)
    {
      if (const double work = workOf(box); work > 0.0)
      {
        boxes.push_back({ box, work });
      }
    });
  return boxes;
}

std::vector<WorkBox> evenWork()
{
  return boxesOf([](const Extent& box) { return static_cast<double>(box.pointCount()); });
}

double workIn(const Extent& extent, const std::vector<WorkBox>& boxes)
{
  double work = 0.0;
  for (const WorkBox& box : boxes)
  {
    const Extent common = commonPart(box.extent, extent);
    work += common.empty() ? 0.0
                           : box.work * static_cast<double>(common.pointCount()) /
        static_cast<double>(box.extent.pointCount());
  }
  return work;
}

double busiestOf(const std::vector<Extent>& parts, const std::vector<WorkBox>& boxes, int halo = 0)
{
  double busiest = 0.0;
  for (Extent part : parts)
  {
    for (int axis = 0; axis < 3 && !part.empty(); ++axis)
    {
      part.min[axis] -= halo;
      part.max[axis] += halo;
    }
    busiest = std::max(busiest, part.empty() ? 0.0 : workIn(part, boxes));
  }
  return busiest;
}

void expectToCoverOnce(const std::vector<Extent>& parts, int step)
{
  std::int64_t points = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (parts[i].empty())
    {
      continue;
    }
    EXPECT_TRUE(kWhole.contains(parts[i]));
    points += parts[i].pointCount();
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(parts[i].min[axis] % step, 0);
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_TRUE(parts[j].empty() || commonPart(parts[i], parts[j]).empty());
    }
  }
  EXPECT_EQ(points, kWhole.pointCount());
}

TEST(WorkCut, CoversTheExtentOnce)
{
  const std::vector<WorkBox> boxes = evenWork();
  for (const int step : { 1, 4, 8 })
  {
    for (const int count : { 1, 2, 3, 7, 16, 40 })
    {
      for (const int halo : { 0, 5 })
      {
        const std::vector<Extent> parts = WorkCut(step, halo).parts(kWhole, count, boxes);
        ASSERT_EQ(parts.size(), static_cast<std::size_t>(count));
        expectToCoverOnce(parts, step);
      }
    }
  }
}

TEST(WorkCut, SharesOutWhatLiesInACorner)
{
  // All work in an eighth of the extent, which equal parts leave to few ranks.
  const std::vector<WorkBox> boxes = boxesOf([](const Extent& box)
    { return box.max[0] < 48 && box.max[1] < 32 && box.max[2] < 20 ? 1.0 : 0.0; });
  for (const int count : { 2, 3, 4, 6, 12 })
  {
    const std::vector<Extent> parts = WorkCut(1, 0).parts(kWhole, count, boxes);
    EXPECT_LT(busiestOf(parts, boxes) * count, 1.1 * static_cast<double>(boxes.size())) << count;
  }
}

TEST(WorkCut, CountsHalos)
{
  // Little work, but where halos of both sides of most cuts would have all of it.
  const std::vector<WorkBox> boxes =
    boxesOf([](const Extent& box) { return box.min[0] >= 40 && box.max[0] < 56 ? 1.0 : 0.0; });
  const std::vector<Extent> parts = WorkCut(4, 8).parts(kWhole, 2, boxes);
  EXPECT_LT(busiestOf(parts, boxes, 8), 0.8 * static_cast<double>(boxes.size()));
  EXPECT_NE(parts[0].size(0), kWhole.size(0) / 2); // where both would have all of it
}

TEST(WorkCut, SharesOutWhatAllHalosSee)
{
  const std::vector<WorkBox> boxes = evenWork();
  const std::vector<Extent> parts = WorkCut(4, 100).parts(kWhole, 4, boxes);
  EXPECT_LT(busiestOf(parts, boxes) * 4.0, 1.2 * busiestOf({ kWhole }, boxes));
}

TEST(WorkCut, LeavesPartsEmptyWhereThereAreTooFewSteps)
{
  const std::vector<Extent> parts = WorkCut(64, 0).parts(kWhole, 5, evenWork());
  expectToCoverOnce(parts, 64);
  EXPECT_EQ(
    std::count_if(parts.begin(), parts.end(), [](const Extent& part) { return part.empty(); }), 3);
}

TEST(WorkBoxSize, DoublesWhileEnoughBoxesAreLeft)
{
  Grid grid;
  grid.dimensions = { 256, 256, 256 };
  EXPECT_EQ(workBoxSize(grid, 1, 4, 512), 32);
  EXPECT_EQ(workBoxSize(grid, 8, 4, 512), 16);
  EXPECT_EQ(workBoxSize(grid, 9, 4, 512), 8);
  EXPECT_EQ(workBoxSize(grid, 1000, 4, 512), 4);
}

} // namespace

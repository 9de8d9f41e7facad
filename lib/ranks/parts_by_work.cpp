#include "base/memory_guard.h"
#include "base/run.h"
#include "culling/candidate_tiles.h"
#include "culling/extent_parts.h"
#include "medial/ranks.h"
#include "ranks/collective.h"
#include "ranks/grid_share.h"
#include "ranks/rank_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

constexpr int kTile = CandidateHierarchy::kTileSize;
/// Boxes of which a tile is tried have so many points along an edge, or a multiple where a part
/// still has enough boxes for the errors to even out.
constexpr int kMinBox = 2 * kTile;
constexpr std::int64_t kEnoughBoxes = 512;

/// A part of the grid and the work for each of its points.
struct WorkBox
{
  Extent extent;
  double work;
};

int boxSize(const Grid& grid, int ranks)
{
  const auto boxes = [&](int size)
  {
    std::int64_t count = 1;
    for (const int dimension : grid.dimensions)
    {
      count *= (dimension + size - 1) / size;
    }
    return count;
  };
  int size = kMinBox;
  while (boxes(2 * size) >= kEnoughBoxes * ranks)
  {
    size *= 2;
  }
  return size;
}

/// Returns some tile of a box, which depends on nothing but the box.
Extent someTile(const Extent& box)
{
  Extent tile = box;
  auto number = static_cast<std::uint32_t>(box.min[0]);
  for (int axis = 0; axis < 3; ++axis)
  {
    number = (number ^ static_cast<std::uint32_t>(box.min[axis])) * 0x9e3779b1u;
    number ^= number >> 15;
    const int tiles = (box.size(axis) + kTile - 1) / kTile;
    tile.min[axis] += kTile * static_cast<int>(number % static_cast<std::uint32_t>(tiles));
    tile.max[axis] = std::min(tile.min[axis] + kTile - 1, box.max[axis]);
  }
  return tile;
}

/// Tries a tile of each box in a part of the grid.
std::vector<WorkBox> workIn(const Extent& part, int size, RankField& field)
{
  std::vector<WorkBox> boxes;
  visitParts(part, size,
    [&](const Extent& box)
    {
      const Extent tile = someTile(box);
      boxes.push_back(
        { box, static_cast<double>(field.tryWork(tile)) / static_cast<double>(tile.pointCount()) });
    });
  return boxes;
}

/// Cuts an extent in two at the end of a tile, again and again, so that all parts have about the
/// same work.
class WorkCut
{
public:
  explicit WorkCut(const std::vector<WorkBox>& boxes)
    : boxes_(boxes)
  {
  }

  void cut(const Extent& extent, int parts, std::vector<Extent>& found) const
  {
    if (parts == 1 || extent.empty())
    {
      found.push_back(extent.empty() ? Extent{} : extent);
      found.resize(found.size() + static_cast<std::size_t>(parts - 1));
      return;
    }
    int axis = 2;
    for (const int other : { 1, 0 })
    {
      axis = extent.size(other) > extent.size(axis) ? other : axis;
    }
    const int low = parts / 2;
    Extent lower = extent;
    Extent upper = extent;
    upper.min[axis] = this->placeToCut(extent, axis, static_cast<double>(low) / parts);
    lower.max[axis] = upper.min[axis] - 1;
    this->cut(lower, low, found);
    this->cut(upper, parts - low, found);
  }

private:
  /// Returns the first layer behind a share of the work.
  int placeToCut(const Extent& extent, int axis, double share) const
  {
    std::vector<double> layers(static_cast<std::size_t>((extent.size(axis) + kTile - 1) / kTile));
    for (const WorkBox& box : boxes_)
    {
      Extent common = commonPart(box.extent, extent);
      const int last = common.max[axis];
      for (int first = common.min[axis]; !common.empty() && first <= last;)
      {
        const int layer = (first - extent.min[axis]) / kTile;
        common.min[axis] = first;
        common.max[axis] = std::min(extent.min[axis] + (layer + 1) * kTile - 1, last);
        layers[layer] += box.work * static_cast<double>(common.pointCount());
        first = common.max[axis] + 1;
      }
    }
    double all = 0.0;
    for (const double layer : layers)
    {
      all += layer;
    }
    double before = 0.0;
    std::size_t cut = 0;
    for (; cut < layers.size() && before + 0.5 * layers[cut] < share * all; ++cut)
    {
      before += layers[cut];
    }
    return std::min(extent.min[axis] + static_cast<int>(cut) * kTile, extent.max[axis] + 1);
  }

  const std::vector<WorkBox>& boxes_;
};

} // namespace

std::vector<Extent> partsByWork(Communicator& communicator, const SurfacePiece& piece,
  const Grid& grid, const DistanceFieldOptions& options)
{
  const int ranks = communicator.size();
  std::vector<Extent> found;
  agree(communicator,
    [&]
    {
      checkFieldOfRanks(grid, {}, options);
      const Run run = Run(options.execution).part(0.0, 0.0); // it can only be cancelled
      const Extent part = partsOfGrid(grid, ranks)[communicator.rank()];
      DistanceFieldOptions unsignedOptions = options;
      unsignedOptions.sign = SignMethod::None;
      RunStatistics statistics;
      RankField field(communicator, piece, grid, part, {}, unsignedOptions, run, statistics);
      RankLists<WorkBox> boxes = listsFor<WorkBox>(communicator);
      withMemoryErrors(part.pointCount(),
        [&] { boxes.front() = workIn(part, boxSize(grid, ranks), field); });
      std::vector<WorkBox> all;
      for (const std::vector<WorkBox>& list : exchanged(communicator, boxes))
      {
        all.insert(all.end(), list.begin(), list.end());
      }
      if (communicator.rank() == 0)
      {
        WorkCut(all).cut(grid.wholeExtent(), ranks, found);
      }
      found = gathered(communicator, found).front();
    });
  return found;
}

} // namespace medial

#include "base/extents.h"
#include "base/memory_guard.h"
#include "base/run.h"
#include "culling/candidate_tiles.h"
#include "medial/ranks.h"
#include "ranks/collective.h"
#include "ranks/field/rank_field.h"
#include "ranks/field/work_cut.h"
#include "sign/side_parts.h"

#include <algorithm>
#include <cstdint>
#include <optional>
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

/// Mixes the bits of a number.
std::uint64_t mixed(std::uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Returns some tile of a box, which depends on nothing but the box.
/// @param number set to a random one, which also depends on the box alone.
Extent someTile(const Extent& box, std::uint64_t& number)
{
  Extent tile = box;
  number = 0;
  for (const int first : box.min)
  {
    number = mixed(number + 0x9e3779b97f4a7c15u + static_cast<std::uint32_t>(first));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto tiles = static_cast<std::uint64_t>((box.size(axis) + kTile - 1) / kTile);
    tile.min[axis] += kTile * static_cast<int>(number % tiles);
    tile.max[axis] = std::min(tile.min[axis] + kTile - 1, box.max[axis]);
    number = mixed(number);
  }
  return tile;
}

/// Tries a tile of each box in a part of the grid.
/// @param isComputed tells of a tile whether it is.
template <typename IsComputed>
std::vector<WorkBox> workIn(const Extent& part, int size, RankField& field,
  const IsComputed& isComputed)
{
  std::vector<WorkBox> boxes;
  visitParts(part, size,
    [&](const Extent& box)
    {
      std::vector<Extent> computed;
      bool all = true;
      visitParts(box, kTile,
        [&](const Extent& tile)
        {
          if (isComputed(tile))
          {
            computed.push_back(tile);
          }
          else
          {
            all = false;
          }
        });
      if (computed.empty())
      {
        return;
      }
      std::uint64_t number = 0;
      Extent tile = someTile(box, number);
      if (!isComputed(tile))
      {
        tile = computed[number % computed.size()];
      }
      const double perPoint =
        static_cast<double>(field.tryWork(tile)) / static_cast<double>(tile.pointCount());
      for (const Extent& extent : all ? std::vector<Extent>{ box } : computed)
      {
        boxes.push_back({ extent, perPoint * static_cast<double>(extent.pointCount()) });
      }
    });
  return boxes;
}

/// @param options of a field without signs, or with those that tell which side is left out.
std::vector<Extent> cutByWork(Communicator& communicator, const SurfacePiece& piece,
  const Grid& grid, const DistanceFieldOptions& options, Side side)
{
  const int ranks = communicator.size();
  if (ranks == 1)
  {
    return { grid.wholeExtent() };
  }
  const Run run = Run(options.execution).part(0.0, 0.0); // it can only be cancelled
  const Extent part = partsOfGrid(grid, ranks)[communicator.rank()];
  RunStatistics statistics;
  RankField field(communicator, piece, grid, options, run, statistics);
  field.bring(communicator, part, part);
  field.settle();
  std::vector<WorkBox> boxes;
  withMemoryErrors(part.pointCount(),
    [&]
    {
      std::optional<SideParts> ofSide;
      if (field.insideRows() != nullptr && !part.empty())
      {
        run.onThreads(
          [&] { ofSide.emplace(*field.insideRows(), side, part, grid.wholeExtent(), kTile); });
      }
      boxes = workIn(part, workBoxSize(grid, ranks, kMinBox, kEnoughBoxes), field,
        [&](const Extent& tile) { return !ofSide || ofSide->meets(tile); });
    });
  return partsOfWork(communicator, grid, WorkCut(kTile, 0), boxes);
}

} // namespace

std::vector<Extent> partsByWork(Communicator& communicator, const SurfacePiece& piece,
  const Grid& grid, const DistanceFieldOptions& options, Side side)
{
  std::vector<Extent> found;
  agree(communicator,
    [&]
    {
      checkFieldOfRanks(grid, {}, options);
      DistanceFieldOptions tried = options;
      if (side == Side::Both || options.sign == SignMethod::Pseudonormal)
      {
        tried.sign = SignMethod::None; // all is computed, and a sign takes little
      }
      found = cutByWork(communicator, piece, grid, tried, side);
    });
  return found;
}

} // namespace medial

#include "culling/candidate_tiles.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace medial
{
namespace
{

/// Splits an extent into halves, quarters or eighths: every axis longer than its limit is cut near
/// its middle, at a multiple of the limit from the start.
std::vector<Extent> split(const Extent& extent, const glm::ivec3& limit)
{
  std::vector<Extent> parts{ extent };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = extent.size(axis);
    if (size <= limit[axis])
    {
      continue;
    }
    const int units = (size + limit[axis] - 1) / limit[axis];
    const int cut = extent.min[axis] + (units + 1) / 2 * limit[axis];
    const std::size_t count = parts.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      Extent upper = parts[i];
      upper.min[axis] = cut;
      parts[i].max[axis] = cut - 1;
      parts.push_back(upper);
    }
  }
  return parts;
}

bool fits(const Extent& extent, const glm::ivec3& limit)
{
  return extent.size(0) <= limit.x && extent.size(1) <= limit.y && extent.size(2) <= limit.z;
}

} // namespace

/// The parts of a node, and the candidates of each.
struct CandidateHierarchy::Parts
{
  std::vector<Extent> extents;
  std::vector<FrameBox> boxes;
  std::vector<int> seeds;
  std::array<std::vector<int>, CandidateFilter::kMaxBoxes> candidates;

  void filter(const CandidateFilter& filter, const std::vector<int>& parent,
    CandidateFilter::Scratch& scratch)
  {
    std::array<std::vector<int>*, CandidateFilter::kMaxBoxes> out{};
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      candidates[i].clear();
      out[i] = &candidates[i];
    }
    filter.filter(parent, boxes.data(), seeds.data(), static_cast<int>(boxes.size()), out.data(),
      scratch);
  }
};

/// Memory of one thread, reused for every node.
struct CandidateHierarchy::Workspace
{
  CandidateFilter::Scratch scratch;
  std::array<Parts, 2> levels; ///< from blocks to leaves
};

CandidateHierarchy::CandidateHierarchy(const CandidateFilter& filter, const GridFrame& frame,
  const Extent& extent, TileHull hull, const ClosestSeeds* seeds)
  : filter_(filter)
  , frame_(frame)
  , extent_(extent)
  , hull_(hull)
  , seeds_(seeds != nullptr && seeds->knows(extent) ? seeds : nullptr)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    blockCounts_[axis] = (extent.size(axis) + kBlockSize - 1) / kBlockSize;
  }
  blocks_.resize(static_cast<std::size_t>(blockCounts_.x) * blockCounts_.y * blockCounts_.z);
  this->descendToBlocks(extent, filter_.allSites());
}

FrameBox CandidateHierarchy::hullOf(const Extent& extent) const
{
  Extent points = extent;
  if (hull_ == TileHull::Cells)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      points.max[axis] = std::min(points.max[axis] + 1, extent_.max[axis]);
    }
  }
  const glm::dvec3 low(points.min[0], points.min[1], points.min[2]);
  const glm::dvec3 high(points.max[0], points.max[1], points.max[2]);
  return { glm::vec3(frame_.sample(0.5 * (low + high))),
    glm::vec3(0.5 * (high - low) * frame_.step) };
}

void CandidateHierarchy::divide(const Extent& node, const glm::ivec3& limit, Parts& parts) const
{
  parts.extents = split(node, limit);
  parts.boxes.clear();
  parts.seeds.clear();
  for (const Extent& part : parts.extents)
  {
    parts.boxes.push_back(this->hullOf(part));
    parts.seeds.push_back(seeds_ != nullptr ? seeds_->at(part) : -1);
  }
}

void CandidateHierarchy::descendToBlocks(const Extent& node, const std::vector<int>& candidates)
{
  Parts parts;
  this->divide(node, glm::ivec3(kBlockSize), parts);
  if (parts.extents.size() == 1)
  {
    std::size_t index = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      index = index * blockCounts_[axis] + (node.min[axis] - extent_.min[axis]) / kBlockSize;
    }
    blocks_[index] = { node, candidates };
    return;
  }
  CandidateFilter::Scratch scratch;
  parts.filter(filter_, candidates, scratch);
  tbb::parallel_for(std::size_t{ 0 }, parts.extents.size(),
    [&](std::size_t i) { this->descendToBlocks(parts.extents[i], parts.candidates[i]); });
}

std::vector<const CandidateHierarchy::Block*> CandidateHierarchy::blocksOf(
  const Extent& layers) const
{
  const std::size_t layer = static_cast<std::size_t>(blockCounts_.x) * blockCounts_.y;
  const std::size_t first = (layers.min[2] - extent_.min[2]) / kBlockSize;
  const std::size_t last = (layers.max[2] - extent_.min[2]) / kBlockSize;
  std::vector<const Block*> blocks;
  for (std::size_t i = first * layer; i < (last + 1) * layer; ++i)
  {
    blocks.push_back(&blocks_[i]);
  }
  return blocks;
}

Extent CandidateHierarchy::layersOf(const Extent& slab) const
{
  Extent layers = slab;
  layers.min[2] -= (slab.min[2] - extent_.min[2]) % kBlockSize;
  const int last = (slab.max[2] - extent_.min[2]) / kBlockSize;
  layers.max[2] = std::min(extent_.min[2] + (last + 1) * kBlockSize - 1, extent_.max[2]);
  return layers;
}

std::size_t CandidateHierarchy::blockBytes() const
{
  return std::accumulate(blocks_.begin(), blocks_.end(), std::size_t{ 0 },
    [](std::size_t sum, const Block& block)
    { return sum + sizeof(Block) + block.candidates.capacity() * sizeof(int); });
}

void CandidateHierarchy::visitLeaves(const Extent& layers, const Visitor& visitor) const
{
  const std::vector<const Block*> blocks = this->blocksOf(layers);
  tbb::enumerable_thread_specific<Workspace> workspaces;
  tbb::parallel_for(std::size_t{ 0 }, blocks.size(),
    [&](std::size_t i)
    {
      this->descendToLeaves(blocks[i]->extent, blocks[i]->candidates, 0, workspaces.local(),
        visitor);
    });
}

std::vector<CandidateTiles> CandidateHierarchy::leafTiles(const Extent& layers,
  const Checkpoint* checkpoint) const
{
  const std::vector<const Block*> blocks = this->blocksOf(layers);
  std::vector<CandidateTiles> tiles(blocks.size());
  const auto listOf = [&](const Extent& tile) -> CandidateTiles&
  {
    std::size_t index = 0;
    for (int axis : { 1, 0 })
    {
      index = index * blockCounts_[axis] + (tile.min[axis] - extent_.min[axis]) / kBlockSize;
    }
    const int firstLayer = (layers.min[2] - extent_.min[2]) / kBlockSize;
    const int layer = (tile.min[2] - extent_.min[2]) / kBlockSize - firstLayer;
    return tiles[index + static_cast<std::size_t>(layer) * blockCounts_.x * blockCounts_.y];
  };
  // One thread visits each block.
  this->visitLeaves(layers,
    [&](const Extent& tile, const std::vector<int>& candidates)
    {
      if (checkpoint != nullptr)
      {
        (*checkpoint)();
      }
      CandidateTiles& list = listOf(tile);
      list.tiles.push_back(tile);
      list.candidates.insert(list.candidates.end(), candidates.begin(), candidates.end());
      list.offsets.push_back(list.candidates.size());
    });
  return tiles;
}

void CandidateHierarchy::descendToLeaves(const Extent& node, const std::vector<int>& candidates,
  int depth, Workspace& workspace, const Visitor& visitor) const
{
  Parts& parts = workspace.levels[depth];
  this->divide(node, glm::ivec3(kLeafSize), parts);
  parts.filter(filter_, candidates, workspace.scratch);
  for (std::size_t i = 0; i < parts.extents.size(); ++i)
  {
    if (fits(parts.extents[i], glm::ivec3(kLeafSize)))
    {
      visitor(parts.extents[i], parts.candidates[i]);
    }
    else
    {
      this->descendToLeaves(parts.extents[i], parts.candidates[i], depth + 1, workspace, visitor);
    }
  }
}

} // namespace medial

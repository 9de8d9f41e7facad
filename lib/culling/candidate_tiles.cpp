#include "medial/culling/candidate_tiles.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>

namespace medial
{
namespace
{

/// The halves, quarters or eighths of an extent: every axis longer than its limit is cut near its
/// middle, at a multiple of the limit from the start.
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

} // namespace

CandidateHierarchy::CandidateHierarchy(const SiteSet& sites, const GridFrame& frame,
  const Extent& extent, int slabSlices)
  : filter_(sites)
  , frame_(frame)
  , extent_(extent)
  , leafSize_(kLeafSize, kLeafSize, std::min(kLeafSize, slabSlices))
  , blockSize_(kBlockSize, kBlockSize, slabSlices)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    blockCounts_[axis] = (extent.size(axis) + blockSize_[axis] - 1) / blockSize_[axis];
  }
  blocks_.resize(static_cast<std::size_t>(blockCounts_.x) * blockCounts_.y * blockCounts_.z);
  this->descendToBlocks(extent, filter_.allSites());
}

FrameBox CandidateHierarchy::pointHull(const Extent& extent) const
{
  const glm::dvec3 low(extent.min[0], extent.min[1], extent.min[2]);
  const glm::dvec3 high(extent.max[0], extent.max[1], extent.max[2]);
  return { glm::vec3(frame_.sample(0.5 * (low + high))),
    glm::vec3(0.5 * (high - low) * frame_.step) };
}

FrameBox CandidateHierarchy::cellHull(const Extent& extent) const
{
  Extent cells = extent;
  for (int axis = 0; axis < 3; ++axis)
  {
    cells.max[axis] = std::min(cells.max[axis] + 1, extent_.max[axis]);
  }
  return this->pointHull(cells);
}

void CandidateHierarchy::descendToBlocks(const Extent& node, const std::vector<int>& parent)
{
  std::vector<int> candidates;
  CandidateFilter::Scratch scratch;
  filter_.filter(parent, this->cellHull(node), candidates, scratch);
  const std::vector<Extent> parts = split(node, blockSize_);
  if (parts.size() == 1)
  {
    std::size_t index = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      index = index * blockCounts_[axis] + (node.min[axis] - extent_.min[axis]) / blockSize_[axis];
    }
    blocks_[index] = { node, std::move(candidates) };
    return;
  }
  tbb::parallel_for_each(parts,
    [&](const Extent& part) { this->descendToBlocks(part, candidates); });
}

Extent CandidateHierarchy::slabExtent(int slab) const
{
  Extent extent = extent_;
  extent.min[2] += slab * blockSize_.z;
  extent.max[2] = std::min(extent.min[2] + blockSize_.z - 1, extent_.max[2]);
  return extent;
}

std::vector<CandidateTiles> CandidateHierarchy::slabTiles(int slab,
  std::vector<CandidateTiles>* cells) const
{
  const std::size_t perSlab = static_cast<std::size_t>(blockCounts_.x) * blockCounts_.y;
  std::vector<CandidateTiles> tiles(perSlab);
  if (cells != nullptr)
  {
    cells->assign(perSlab, {});
  }
  tbb::parallel_for(std::size_t{ 0 }, perSlab,
    [&](std::size_t i)
    {
      const Block& block = blocks_[slab * perSlab + i];
      CandidateFilter::Scratch scratch;
      this->descendToLeaves(block.extent, block.candidates, tiles[i],
        cells != nullptr ? &(*cells)[i] : nullptr, scratch);
    });
  return tiles;
}

void CandidateHierarchy::descendToLeaves(const Extent& node, const std::vector<int>& parent,
  CandidateTiles& tiles, CandidateTiles* cells, CandidateFilter::Scratch& scratch) const
{
  const std::vector<Extent> parts = split(node, leafSize_);
  if (parts.size() > 1)
  {
    std::vector<int> candidates;
    filter_.filter(parent, this->cellHull(node), candidates, scratch);
    for (const Extent& part : parts)
    {
      this->descendToLeaves(part, candidates, tiles, cells, scratch);
    }
    return;
  }
  if (cells == nullptr)
  {
    this->addLeaf(node, this->pointHull(node), parent, tiles, scratch);
    return;
  }
  this->addLeaf(node, this->cellHull(node), parent, *cells, scratch);
  const std::vector<int> candidates(cells->candidates.begin() +
      static_cast<std::ptrdiff_t>(cells->offsets.end()[-2]),
    cells->candidates.end());
  this->addLeaf(node, this->pointHull(node), candidates, tiles, scratch);
}

void CandidateHierarchy::addLeaf(const Extent& tile, const FrameBox& hull,
  const std::vector<int>& parent, CandidateTiles& tiles, CandidateFilter::Scratch& scratch) const
{
  tiles.tiles.push_back(tile);
  filter_.filter(parent, hull, tiles.candidates, scratch);
  tiles.offsets.push_back(tiles.candidates.size());
}

} // namespace medial

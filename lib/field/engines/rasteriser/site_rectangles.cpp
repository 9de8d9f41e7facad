#include "field/engines/rasteriser/site_rectangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>

namespace medial
{
namespace
{

constexpr int kLongestSide = 64;

struct Reach
{
  std::int16_t lowX = std::numeric_limits<std::int16_t>::max();
  std::int16_t lowY = std::numeric_limits<std::int16_t>::max();
  std::int16_t highX = -1;
  std::int16_t highY = -1;

  /// Coordinates are relative to the slab and fit their type: see kMaxDimension.
  void include(const Extent& tile, const Extent& slab)
  {
    lowX = std::min(lowX, static_cast<std::int16_t>(tile.min[0] - slab.min[0]));
    lowY = std::min(lowY, static_cast<std::int16_t>(tile.min[1] - slab.min[1]));
    highX = std::max(highX, static_cast<std::int16_t>(tile.max[0] - slab.min[0]));
    highY = std::max(highY, static_cast<std::int16_t>(tile.max[1] - slab.min[1]));
  }
};

/// Adds a rectangle in parts that are short enough to interpolate over.
void addRectangles(int site, const glm::ivec3& low, const glm::ivec3& high,
  std::vector<SiteRectangle>& rectangles)
{
  for (int y = low.y; y <= high.y; y += kLongestSide)
  {
    for (int x = low.x; x <= high.x; x += kLongestSide)
    {
      rectangles.push_back({ site, { x, y, low.z },
        { std::min(x + kLongestSide - 1, high.x), std::min(y + kLongestSide - 1, high.y),
          high.z } });
    }
  }
}

std::vector<SiteRectangle> layerRectangles(const std::vector<CandidateTiles>& blocks,
  const Extent& slab, int siteCount, int firstSlice)
{
  std::vector<Reach> reaches(siteCount);
  int lastSlice = firstSlice;
  for (const CandidateTiles& block : blocks)
  {
    for (std::size_t t = 0; t < block.tiles.size(); ++t)
    {
      const Extent& tile = block.tiles[t];
      if (tile.min[2] != firstSlice)
      {
        continue;
      }
      lastSlice = tile.max[2];
      for (std::size_t i = block.offsets[t]; i < block.offsets[t + 1]; ++i)
      {
        reaches[block.candidates[i]].include(tile, slab);
      }
    }
  }
  std::vector<SiteRectangle> rectangles;
  for (int site = 0; site < siteCount; ++site)
  {
    const Reach& reach = reaches[site];
    if (reach.highX >= 0)
    {
      addRectangles(site,
        { slab.min[0] + reach.lowX, slab.min[1] + reach.lowY, std::max(firstSlice, slab.min[2]) },
        { slab.min[0] + reach.highX, slab.min[1] + reach.highY, std::min(lastSlice, slab.max[2]) },
        rectangles);
    }
  }
  return rectangles;
}

/// Returns the first slices of the layers of tiles that a slab cuts, in ascending order.
std::vector<int> layersIn(const Extent& slab, const std::vector<CandidateTiles>& blocks)
{
  std::set<int> firstSlices;
  for (const CandidateTiles& block : blocks)
  {
    for (const Extent& tile : block.tiles)
    {
      if (tile.min[2] <= slab.max[2] && tile.max[2] >= slab.min[2])
      {
        firstSlices.insert(tile.min[2]);
      }
    }
  }
  return { firstSlices.begin(), firstSlices.end() };
}

} // namespace

std::vector<SiteRectangle> siteRectangles(const std::vector<CandidateTiles>& tiles,
  const Extent& slab, int siteCount)
{
  const std::vector<int> firstSlices = layersIn(slab, tiles);
  std::vector<std::vector<SiteRectangle>> perLayer(firstSlices.size());
  tbb::parallel_for(std::size_t{ 0 }, firstSlices.size(),
    [&](std::size_t layer)
    { perLayer[layer] = layerRectangles(tiles, slab, siteCount, firstSlices[layer]); });
  std::vector<SiteRectangle> all;
  for (const auto& rectangles : perLayer)
  {
    all.insert(all.end(), rectangles.begin(), rectangles.end());
  }
  return all;
}

} // namespace medial

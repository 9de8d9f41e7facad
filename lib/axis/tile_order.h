#pragma once

#include "axis/axis_geometry.h"
#include "medial/grid.h"

#include <glm/glm.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace medial
{

/// Returns the numbers 0 .. count - 1 in the order of tiles of grid cells, so that those in a row
/// are close together in all directions, even where only few cells have any: exact queries answer
/// such points together. Tiles are ordered in cubes of sixteen along each axis, and there in
/// Morton's order.
/// @param cellOf returns the grid cell, or the grid point, of a number.
template <typename CellOf>
std::vector<std::uint32_t> tileOrder(const Extent& extent, std::size_t count, const CellOf& cellOf)
{
  constexpr int kTile = 8;  // cells along an axis
  constexpr int kCube = 16; // tiles along an axis
  const glm::ivec3 first(extent.min[0] - 1, extent.min[1] - 1, extent.min[2] - 1);
  const auto cubesAlong = [&](int axis)
  { return static_cast<std::size_t>((extent.size(axis) + 1) / (kTile * kCube) + 1); };
  const std::size_t width = cubesAlong(0);
  const std::size_t height = cubesAlong(1);
  // The bits of the numbers below sixteen, each moved to every third place.
  constexpr std::array<std::size_t, kCube> kApart{ 0, 1, 8, 9, 64, 65, 72, 73, 512, 513, 520, 521,
    576, 577, 584, 585 };
  const auto tileOf = [&](std::size_t i)
  {
    const glm::ivec3 tile = (glm::ivec3(cellOf(i)) - first) / kTile;
    const glm::ivec3 cube = tile / kCube;
    const glm::ivec3 within = tile % kCube;
    return ((cube.z * height + cube.y) * width + cube.x) * (kCube * kCube * kCube) +
      (kApart[within.x] | kApart[within.y] << 1 | kApart[within.z] << 2);
  };
  std::vector<std::uint32_t> ends(width * height * cubesAlong(2) * (kCube * kCube * kCube) + 1, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    ++ends[tileOf(i) + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::uint32_t> order(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    order[ends[tileOf(i)]++] = static_cast<std::uint32_t>(i);
  }
  return order;
}

/// In the order of tiles a block of this size has several in most of its tiles.
constexpr std::size_t kBlock = 512;

/// Calls work(begin, end) for blocks of [0, count), on all threads.
template <typename Work>
void inBlocks(const AxisGeometry& geometry, std::size_t count, const Work& work)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kBlock),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      geometry.checkpoint();
      work(range.begin(), range.end());
    });
}

/// The same, with what work(begin, end) returns for each block, in their order. The blocks do not
/// depend on threads.
template <typename Work>
auto resultsOfBlocks(const AxisGeometry& geometry, std::size_t count, const Work& work)
{
  std::vector<decltype(work(std::size_t{ 0 }, count))> results((count + kBlock - 1) / kBlock);
  tbb::parallel_for(std::size_t{ 0 }, results.size(),
    [&](std::size_t block)
    {
      geometry.checkpoint();
      results[block] = work(block * kBlock, std::min((block + 1) * kBlock, count));
    });
  return results;
}

} // namespace medial

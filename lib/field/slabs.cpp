#include "field/slabs.h"

#include <algorithm>

namespace medial
{
namespace
{

constexpr std::size_t kDefaultMemoryMiB = 512;

} // namespace

std::size_t slabMemory(std::size_t memoryMiB)
{
  return (memoryMiB > 0 ? memoryMiB : kDefaultMemoryMiB) * 1024 * 1024;
}

int slabSlices(const Extent& extent, std::size_t bytesPerPoint, std::size_t memoryMiB)
{
  const std::size_t slice = std::max<std::size_t>(bytesPerPoint, 1) *
    static_cast<std::size_t>(extent.size(0)) * static_cast<std::size_t>(extent.size(1));
  const std::size_t fitting = slabMemory(memoryMiB) / slice;
  int slices = kMaxSlices;
  while (slices > 1 && static_cast<std::size_t>(slices) > fitting)
  {
    slices /= 2;
  }
  return slices;
}

std::vector<Extent> slabsOf(const Extent& extent, int slices)
{
  std::vector<Extent> slabs;
  for (int first = extent.min[2]; first <= extent.max[2]; first += slices)
  {
    slabs.push_back(extent);
    slabs.back().min[2] = first;
    slabs.back().max[2] = std::min(first + slices - 1, extent.max[2]);
  }
  return slabs;
}

} // namespace medial

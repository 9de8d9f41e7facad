#include "thinning/voxel_solid.h"

#include "base/simd.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace medial
{
namespace
{

/// Marks the points of a row that are inside, or those that are not.
MEDIAL_VECTORISED void markSide(const float* distance, bool inside, int count, std::uint8_t* marks)
{
  const std::uint8_t other = inside ? 0 : 1;
  for (int i = 0; i < count; ++i)
  {
    marks[i] = static_cast<std::uint8_t>((distance[i] < 0.0f ? 1 : 0) ^ other);
  }
}

MEDIAL_VECTORISED void scaleMarked(const float* distance, float scale, std::size_t count,
  const std::uint8_t* marks, float* depths)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const float depth = scale * std::abs(distance[i]);
    depths[i] = marks[i] != 0 ? depth : -1.0f;
  }
}

} // namespace

void DepthField::markWanted(std::size_t first, int count, std::uint8_t* marks) const
{
  if (side_ == Side::Both)
  {
    std::fill_n(marks, count, std::uint8_t{ 1 });
  }
  else
  {
    markSide(distance_ + first, side_ == Side::Interior, count, marks);
  }
  for (int i = 0; i < count && siteColours_ != nullptr; ++i)
  {
    marks[i] = marks[i] != 0 && siteColours_[closestSites_[first + i]] == colour_ ? 1 : 0;
  }
}

void DepthField::readMarked(std::size_t first, std::size_t count, const std::uint8_t* marks,
  float* depths) const
{
  scaleMarked(distance_ + first, scale_, count, marks, depths);
}

void SolidVoxels::mark(const glm::ivec3& first, int count, std::uint8_t* marks) const
{
  std::fill_n(marks, count, std::uint8_t{ 0 });
  const int begin = std::max(first.x, 1);
  const int end = std::min(first.x + count, grid_.x - 1);
  if (first.y > 0 && first.y < grid_.y - 1 && first.z > 0 && first.z < grid_.z - 1 && begin < end)
  {
    const glm::ivec3 at =
      glm::ivec3(begin, first.y, first.z) - glm::ivec3(part_.min[0], part_.min[1], part_.min[2]);
    depth_.markWanted((static_cast<std::size_t>(at.z) * part_.size(1) + at.y) * part_.size(0) +
        at.x,
      end - begin, marks + (begin - first.x));
  }
}

VoxelMask voxelsOf(const SolidVoxels& solid)
{
  const Extent& part = solid.part();
  VoxelMask voxels(static_cast<std::size_t>(part.pointCount()));
  tbb::parallel_for(part.min[2], part.max[2] + 1,
    [&](int z)
    {
      std::uint8_t* row =
        voxels.data() + static_cast<std::size_t>(z - part.min[2]) * part.size(1) * part.size(0);
      for (int y = part.min[1]; y <= part.max[1]; ++y, row += part.size(0))
      {
        solid.mark({ part.min[0], y, z }, part.size(0), row);
      }
    });
  return voxels;
}

} // namespace medial

#pragma once

#include "base/huge_pages.h"
#include "medial/grid.h"
#include "medial/side.h"
#include "thinning/cubical_complex.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// The signed distances of a whole grid, seen from one side of the surface.
class DepthField
{
public:
  /// @param distance x fastest, world units; negative inside unless unsigned.
  /// @param side Both for an unsigned field.
  /// @param unit world units per local unit.
  DepthField(const float* distance, Side side, double unit)
    : distance_(distance)
    , side_(side)
    , scale_(static_cast<float>(1.0 / unit))
  {
  }

  /// Restricts the side to grid points whose closest site has a colour; the arrays must outlive
  /// this object.
  void restrict(const std::int32_t* closestSites, const int* siteColours, int colour)
  {
    closestSites_ = closestSites;
    siteColours_ = siteColours;
    colour_ = colour;
  }

  /// Whether a grid point belongs to the side.
  bool wanted(std::size_t point) const
  {
    return (side_ == Side::Both || (distance_[point] < 0.0f) == (side_ == Side::Interior)) &&
      (siteColours_ == nullptr || siteColours_[closestSites_[point]] == colour_);
  }
  /// Marks those of a row of grid points that belong to the side by 1, others by 0.
  void markWanted(std::size_t first, int count, std::uint8_t* marks) const;
  /// Returns the distance to the surface in local units; negative if the point does not belong to
  /// the side.
  float at(std::size_t point) const
  {
    return this->wanted(point) ? this->distance(point) : -this->distance(point);
  }
  /// Returns the distance to the surface in local units, whatever the side.
  float distance(std::size_t point) const { return scale_ * std::abs(distance_[point]); }
  /// Sets the depths of a row of grid points: those distances where marks are not 0, -1 elsewhere.
  void readMarked(std::size_t first, std::size_t count, const std::uint8_t* marks,
    float* depths) const;

private:
  const float* distance_;
  Side side_;
  float scale_;
  const std::int32_t* closestSites_ = nullptr;
  const int* siteColours_ = nullptr;
  int colour_ = 0;
};

/// The voxels of a solid: those around the points of a side. Points on the border of the grid are
/// left out, so that every corner of a voxel lies in a grid cell.
class SolidVoxels
{
public:
  /// @param depth of a part of the grid; must outlive this.
  /// @param part of the grid.
  /// @param grid grid points along each axis.
  SolidVoxels(const DepthField& depth, const Extent& part, const glm::ivec3& grid)
    : depth_(depth)
    , part_(part)
    , grid_(grid)
  {
  }

  const DepthField& depth() const { return depth_; }
  const Extent& part() const { return part_; }
  /// Marks those of a row of grid points that have a voxel by 1, others by 0.
  /// @param first point of the row, along x; those on the border of the grid and beyond it need not
  ///   be in the part.
  void mark(const glm::ivec3& first, int count, std::uint8_t* marks) const;

private:
  const DepthField& depth_;
  Extent part_;
  glm::ivec3 grid_;
};

/// Which points of a part of a grid have a voxel in a solid: 1 or 0 for each, x fastest.
using VoxelMask = ZeroedVector<std::uint8_t>;

VoxelMask voxelsOf(const SolidVoxels& solid);

/// Whether the voxel around a grid point is one of SolidVoxels.
inline bool inSolid(const DepthField& depth, const CubicalComplex& complex, const glm::ivec3& point)
{
  const glm::ivec3& size = complex.grid();
  return point.x > 0 && point.y > 0 && point.z > 0 && point.x < size.x - 1 &&
    point.y < size.y - 1 && point.z < size.z - 1 &&
    depth.wanted(CubicalComplex::index(complex.cell(point, kVertexKind)));
}

} // namespace medial

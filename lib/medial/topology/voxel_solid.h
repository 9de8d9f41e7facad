#pragma once

#include "medial/medial/medial_axis.h"
#include "medial/medial/topology/cell_lattice.h"
#include "medial/medial/topology/cell_topology.h"

#include <cstddef>

namespace medial
{

/// Signed distances of a whole grid, seen from one side of the surface.
class DepthField
{
public:
  /// @param distance x fastest, world units; negative inside unless unsigned.
  /// @param side Both for an unsigned field.
  /// @param unit world units per frame unit.
  DepthField(const float* distance, Side side, double unit)
    : distance_(distance)
    , side_(side)
    , scale_(static_cast<float>((side == Side::Interior ? -1.0 : 1.0) / unit))
  {
  }

  /// Whether a grid point belongs to the side.
  bool wanted(std::size_t point) const
  {
    return side_ == Side::Both || (distance_[point] < 0.0f) == (side_ == Side::Interior);
  }
  /// Distance to the surface in frame units, negative on the other side.
  float at(std::size_t point) const { return scale_ * distance_[point]; }

private:
  const float* distance_;
  Side side_;
  float scale_;
};

/// The closed voxels around the grid points of a side, with all their faces, edges and corners.
/// Points on the border of the grid do not count, so that every corner lies in a grid cell.
CellLattice voxelSolid(const DepthField& depth, const glm::ivec3& size);

/// Whether the voxel around a grid point belongs to that solid.
bool inSolid(const DepthField& depth, const CellLattice& lattice, const glm::ivec3& point);

/// Topology of a solid made by voxelSolid(): voxels that share as much as a corner are connected.
CellTopology topologyOf(const CellLattice& solid);

} // namespace medial

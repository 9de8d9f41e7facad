#pragma once

#include "medial/cell_topology.h"
#include "medial/compute_medial_axis.h"
#include "medial/grid.h"

#include <vector>

// Topology by counting and flooding, to compare with the library's.
namespace medial::test
{

/// Of the closed unit cubes around some grid points: their cells counted on a grid twice as fine,
/// components flooded through corners, cavities flooded through faces.
/// @param inside one element a grid point, x fastest.
CellTopology voxelTopology(const std::vector<char>& inside, const std::array<int, 3>& dimensions);

/// Which grid points belong to a solid: those of the side that are not on the border of the grid.
/// @param side Both: all.
std::vector<char> solidVoxels(const std::vector<float>& distance,
  const std::array<int, 3>& dimensions, Side side);

/// Components and Euler characteristic of an axis by its cells; the other members are 0.
CellTopology countedTopology(const MedialAxis& axis);

} // namespace medial::test

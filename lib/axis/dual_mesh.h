#pragma once

#include "field/crossing.h"
#include "medial/grid.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// The mesh dual to the grid: a vertex in every grid cell with a crossed edge, a quad around every
/// crossed edge that lies inside the grid. Both sides of the surface have vertices of their own, so
/// that a cell cut by a thin wall does not join them.
struct DualMesh
{
  /// Cell (i,j,k) of vertex v spans the grid points from (i,j,k) to (i+1,j+1,k+1).
  std::vector<glm::ivec3> cells;
  /// Edges incident[offsets[v]] .. incident[offsets[v+1]-1] of its cell are crossed.
  std::vector<std::size_t> offsets{ 0 };
  std::vector<std::size_t> incident;
  std::vector<std::array<std::int64_t, 4>> quads;
};

DualMesh dualMesh(const std::vector<Crossing>& crossings, const Extent& extent);

} // namespace medial

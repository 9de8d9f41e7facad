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

/// The mesh dual to the grid: a vertex in every grid cell with a crossed edge, and a quad around
/// every crossed edge inside the grid. The two sides of the surface have separate vertices, so a
/// grid cell that a thin wall cuts does not join them.
struct DualMesh
{
  /// The grid cell (i,j,k) of vertex v spans the grid points from (i,j,k) to (i+1,j+1,k+1).
  std::vector<glm::ivec3> cells;
  /// Crossings incident[offsets[v]] to incident[offsets[v+1]-1] lie on edges of its grid cell.
  std::vector<std::size_t> offsets{ 0 };
  std::vector<std::size_t> incident;
  std::vector<std::array<std::int64_t, 4>> quads;
};

DualMesh dualMesh(const std::vector<Crossing>& crossings, const Extent& extent);

} // namespace medial

#pragma once

#include "axis/edge_table.h"
#include "field/crossing.h"
#include "medial/grid.h"

#include <glm/glm.hpp>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// The mesh dual to the grid: a vertex in every grid cell with a crossed edge, and a quad around
/// every crossed edge. The two sides of the surface have separate vertices, so a
/// grid cell that a thin wall cuts does not join them.
struct DualMesh
{
  /// The grid cell (i,j,k) of vertex v spans the grid points from (i,j,k) to (i+1,j+1,k+1).
  std::vector<glm::ivec3> cells;
  /// Crossings incident[offsets[v]] to incident[offsets[v+1]-1] lie on edges of its grid cell.
  std::vector<std::size_t> offsets{ 0 };
  std::vector<std::uint32_t> incident;
  /// The vertices around each crossing, in cyclic order.
  std::vector<std::array<std::uint32_t, 4>> corners;
};

DualMesh dualMesh(const std::vector<Crossing>& crossings, const Extent& extent);

/// Returns for each vertex the bits that any of its crossings has.
/// @param bitsOf returns the bits of a crossing, at most eight.
template <typename BitsOf>
std::vector<std::uint8_t> bitsAround(const DualMesh& mesh, const BitsOf& bitsOf)
{
  constexpr std::size_t kTogether = 4096;
  std::vector<std::uint8_t> bits(mesh.cells.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, bits.size(), kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t v = range.begin(); v != range.end(); ++v)
      {
        for (std::size_t i = mesh.offsets[v]; i < mesh.offsets[v + 1]; ++i)
        {
          bits[v] |= static_cast<std::uint8_t>(bitsOf(mesh.incident[i]));
        }
      }
    });
  return bits;
}

/// Stands for a vertex that is not there.
constexpr std::size_t kNoVertex = static_cast<std::size_t>(-1);

/// A part of a dual mesh.
struct DualSubmesh
{
  DualMesh mesh;
  std::vector<std::size_t> origins; ///< of its vertices: those of the whole mesh
};

/// Returns the dual mesh of some of the crossings.
/// @param kept for each crossing not 0 if it stays; those that stay are numbered anew, in order.
DualSubmesh submesh(const DualMesh& mesh, const std::vector<std::uint8_t>& kept);

/// Whether all cells of a quad are inside the grid.
bool isWithin(const DualMesh& mesh, const std::array<std::uint32_t, 4>& quad, const Extent& extent);

/// Returns the quads around the crossings inside the grid.
std::vector<std::array<std::int64_t, 4>> quadsWithin(const DualMesh& mesh, const Extent& extent);

/// Returns the edges of one quad only, the rims: in ascending order, the lower end first.
/// @param cells the grid cell of each vertex.
std::vector<EdgeTable::Edge> rimEdges(const std::vector<glm::ivec3>& cells,
  const std::vector<std::array<std::int64_t, 4>>& quads);

/// Returns the vertices of rims, ascending.
std::vector<std::size_t> verticesOn(const std::vector<EdgeTable::Edge>& rims);

} // namespace medial

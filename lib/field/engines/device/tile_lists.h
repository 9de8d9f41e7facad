#pragma once

#include "field/engines/device/device_mesh.h"
#include "field/engines/device/kernels.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// What the kernels count in a slab; see counters.glsl.
struct SearchCounters
{
  std::uint32_t listLength;
  std::uint32_t tests;
  std::uint32_t pairs;
  std::uint32_t evaluations;
  std::uint32_t withoutSite;
  std::uint32_t listed;
};

/// Culling on the device: which groups of elements can hold the closest points of the tiles of a
/// slab, 8 grid points a side. Nodes of the mesh's tree are tested for boxes of 64, 32, 16 and 8
/// points. GPU thread only.
class TileLists
{
public:
  /// Number of sizes of boxes.
  static constexpr std::size_t kLevels = 4;

  /// @param mesh, kernels must outlive this.
  TileLists(const DeviceMesh& mesh, Kernels& kernels);

  /// Number of tiles of a slab along the axes.
  static glm::ivec3 tilesOf(const Extent& slab);

  /// Makes room for a slab, and sets the counters to zero.
  void begin(const Extent& slab);
  /// Culls for the boxes of one size after the other, from 0 to kLevels - 1.
  void refine(const GridFrame& frame, const Extent& slab, std::size_t level);
  /// Makes room for all lists of a slab that had too little of it.
  /// @return whether there was too little.
  bool grow(const SearchCounters& counters);

  /// Sets the uniforms of grid.glsl and reach.glsl.
  void setGrid(const gl::ShaderProgram& kernel, const GridFrame& frame, const Extent& slab) const;

  /// Of the current slab.
  const glm::ivec3& tiles() const { return levels_.back().boxes; }
  /// Range of the first tile.
  int firstTile() const { return levels_.back().first; }
  const gl::Buffer& ranges() const { return ranges_; }
  const gl::Buffer& lists() const { return lists_; }
  const gl::Buffer& counters() const { return counters_; }

private:
  /// The boxes of one size over a slab.
  struct BoxLevel
  {
    int size;
    glm::ivec3 boxes;
    int first;     ///< range of the first box
    int treeLevel; ///< of the nodes in its lists
  };

  const DeviceMesh& mesh_;
  Kernels& kernels_;
  std::vector<BoxLevel> levels_; ///< of the current slab
  std::int64_t room_ = 0;        ///< for all lists
  gl::Buffer ranges_, lists_, counters_;
};

} // namespace medial

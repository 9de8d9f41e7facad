#pragma once

#include "field/engines/device/device_clock.h"
#include "field/engines/device/device_mesh.h"
#include "field/engines/device/kernels.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <cstdint>
#include <functional>
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
  std::uint32_t crossings;
};

/// Finds the elements nearest to the grid points of a slab: nodes of the mesh's tree are culled for
/// boxes of 64, 32, 16 and 8 grid points a side, and what is left is evaluated. GPU thread only.
class ElementSearch
{
public:
  /// @param mesh, kernels must outlive this.
  ElementSearch(const DeviceMesh& mesh, Kernels& kernels);

  /// Returns what there is to do for a slab, in steps of limited time. The steps may be run on the
  /// GPU thread only, in order.
  /// @param clock for the phases; must outlive the steps.
  std::vector<std::function<void()>> steps(const GridFrame& frame, const Extent& slab,
    DeviceClock& clock);

  /// Makes room for all lists of a slab that had too little of it.
  /// @return whether there was too little.
  bool grow(const SearchCounters& counters);

  /// Slots of elements; -1 where there is none.
  const gl::Buffer& winners() const { return winners_; }
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

  void begin(const Extent& slab);
  void setGrid(const gl::ShaderProgram& kernel, const GridFrame& frame, const Extent& slab) const;
  void refine(const GridFrame& frame, const Extent& slab, std::size_t level);
  void evaluate(const GridFrame& frame, const Extent& slab, int layer, int layers);

  const DeviceMesh& mesh_;
  Kernels& kernels_;
  std::vector<BoxLevel> levels_; ///< of the current slab
  std::int64_t room_ = 0;        ///< for all lists
  gl::Buffer ranges_, lists_, counters_, winners_;
};

} // namespace medial

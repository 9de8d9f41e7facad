#pragma once

#include "field/engines/device/device_clock.h"
#include "field/engines/device/device_mesh.h"
#include "field/engines/device/kernels.h"
#include "field/engines/device/tile_lists.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace medial
{

/// Finds the elements nearest to the grid points of a slab: those that culling leaves are
/// evaluated. GPU thread only.
class ElementSearch
{
public:
  /// Grid points of a block, for which an element is evaluated at once.
  static constexpr int kPointsOfBlock = 8;

  /// @param mesh, kernels must outlive this.
  ElementSearch(const DeviceMesh& mesh, Kernels& kernels);

  /// Returns what there is to do for a slab, in steps of limited time. The steps may be run on the
  /// GPU thread only, in order.
  /// @param clock for the phases; must outlive the steps.
  std::vector<std::function<void()>> steps(const GridFrame& frame, const Extent& slab,
    DeviceClock& clock);

  /// As TileLists::grow().
  bool grow(const SearchCounters& counters) { return lists_.grow(counters); }

  /// Sites that name the nearest elements; -1 where there is none.
  const gl::Buffer& winners() const { return winners_; }
  const gl::Buffer& counters() const { return lists_.counters(); }

private:
  void evaluate(const GridFrame& frame, const Extent& slab, int layer, int layers);

  const DeviceMesh& mesh_;
  Kernels& kernels_;
  int tilesOfStep_; ///< so that a step takes a tenth of a second at most
  TileLists lists_;
  gl::Buffer winners_;
};

} // namespace medial

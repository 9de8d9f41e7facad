#pragma once

#include "base/disjoint_sets.h"
#include "medial/cell_topology.h"
#include "medial/grid.h"
#include "thinning/voxel_solid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Connected parts of the closed voxels of a solid, and of the open rest, in a part of a grid.
/// Voxels that share only a corner are connected; what is outside is so through faces.
class SolidParts
{
public:
  /// @param part of the grid to look at. The solid must know the points below it as well.
  SolidParts(const SolidVoxels& solid, const Extent& part);

  /// Returns how many parts there are of the solid, or of the rest.
  std::int64_t count(bool inside);
  /// Of the cells of closed voxels at the positions of the part (CubicalComplex): the sum over
  /// dimensions of (-1)^dimension times their number.
  std::int64_t eulerCharacteristic() const { return eulerCharacteristic_; }

  /// Neighbouring points of a row, all inside the solid or all outside.
  struct Run
  {
    int first; ///< along x
    int last;
    bool inside;
  };
  /// Calls visit(run, y, z, label) for all runs, whose labels tell connected parts apart: numbers
  /// below labels().
  template <typename Visit>
  void visitRuns(const Visit& visit)
  {
    for (std::size_t row = 0; row + 1 < rows_.size(); ++row)
    {
      const auto sizeY = static_cast<std::size_t>(part_.size(1));
      for (std::size_t run = rows_[row]; run < rows_[row + 1]; ++run)
      {
        visit(runs_[run], part_.min[1] + static_cast<int>(row % sizeY),
          part_.min[2] + static_cast<int>(row / sizeY), sets_.find(static_cast<std::int64_t>(run)));
      }
    }
  }
  std::int64_t labels() const { return static_cast<std::int64_t>(runs_.size()); }

private:
  void scan(const SolidVoxels& solid);
  void join(int y, int z, int otherY, int otherZ, bool diagonal);

  Extent part_;
  std::vector<Run> runs_;
  std::vector<std::size_t> rows_{ 0 }; ///< where the runs of each row begin
  DisjointSets sets_;
  std::int64_t eulerCharacteristic_ = 0;
};

/// Returns the topology of closed voxels that have some parts.
/// @param inside, outside numbers of connected parts.
CellTopology solidTopology(std::int64_t inside, std::int64_t outside,
  std::int64_t eulerCharacteristic);

/// Computes the topology of a solid in a whole grid.
CellTopology topologyOf(const SolidVoxels& solid);

} // namespace medial

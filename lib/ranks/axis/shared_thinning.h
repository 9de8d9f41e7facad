#pragma once

#include "axis/axis_geometry.h"
#include "axis/sheets/sheet_selection.h"
#include "base/checkpoint.h"
#include "medial/cell_topology.h"
#include "ranks/axis/asked_field.h"
#include "ranks/axis/corner_numbers.h"
#include "ranks/axis/kept_field.h"
#include "ranks/axis/preservation_input.h"
#include "thinning/solid_thinning.h"
#include "thinning/voxel_solid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// A solid as a rank knows it.
struct ThinningPart
{
  const AxisGeometry* geometry; ///< in its part of the axis; null without one
  AskedField& field;            ///< there
  DepthField depth;             ///< in that
  const KeptField& keptField;   ///< where the rank has computed it
  DepthField keptDepth;         ///< in that
};

/// Thins solids for all ranks. Each finds out what is undecided in its part; the first one burns
/// the core, and gets the depths around it from the others. It has no field and no surface. Every
/// rank calls all of it.
class SharedThinning
{
public:
  explicit SharedThinning(const PreservationInput& input);

  /// Brings the selected crossings to the first rank.
  /// @param crossings of this rank's part and a halo, which are selected.
  /// @param sheets of these; null without a part.
  void select(const std::vector<Crossing>& crossings, const SheetSelection* sheets);

  /// Thins a solid.
  /// @param part with the field at the ends of the crossings.
  /// @return what is left, on the first rank.
  std::vector<CornerCells> thin(const ThinningPart& part, const Checkpoint& checkpoint);

  /// Topology of the solids since select(), on the first rank.
  const CellTopology& topology() const { return topology_; }
  /// Drops what thinning alone needs.
  void finish();

private:
  bool isFirst() const { return input_.communicator.rank() == 0; }
  template <typename Work>
  void atFirst(const Work& work) const;
  SelectedCrossings selectedWithin(const ThinningPart& part) const;
  std::vector<std::size_t> undecided(const RankPart& part, const SolidVoxels& here,
    const SolidThinning* thinning, const Checkpoint& checkpoint) const;
  std::vector<std::uint8_t> separating(const ThinningPart& part,
    const std::vector<std::int64_t>& edges) const;

  PreservationInput input_;
  CornerNumbers corners_;
  std::vector<Crossing> own_; ///< those of this rank's part that are selected
  ///@{
  /// Of the whole grid, on the first rank.
  SelectedCrossings selected_;
  std::vector<std::int64_t> numbers_; ///< of these crossings, ascending
  CellTopology topology_;
  ///@}
};

} // namespace medial

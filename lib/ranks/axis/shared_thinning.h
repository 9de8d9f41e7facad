#pragma once

#include "axis/axis_geometry.h"
#include "axis/sheets/sheet_selection.h"
#include "base/checkpoint.h"
#include "medial/cell_topology.h"
#include "ranks/axis/corner_numbers.h"
#include "ranks/axis/preservation_input.h"
#include "thinning/solid_thinning.h"
#include "thinning/voxel_solid.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// What a rank knows of its part for thinning.
struct ThinningPart
{
  const AxisGeometry* geometry;                  ///< null without a part
  const std::vector<std::int32_t>& closestSites; ///< here, at the points of the field
  const DepthField& depth;                       ///< of the side, or of a colour
};

/// Thins solids on the first rank, for all. It knows the distances in the whole grid and the
/// selected crossings; of the surface it knows what the others answer. Every rank calls all of it.
class SharedThinning
{
public:
  /// Brings the distances to the first rank.
  /// @param extents of all ranks in the share.
  SharedThinning(const PreservationInput& input, const std::vector<Extent>& extents);

  /// Brings the selected crossings to the first rank.
  /// @param crossings of this rank's part and a halo, which are selected.
  /// @param sheets of these; null without a part.
  void select(const std::vector<Crossing>& crossings, const SheetSelection* sheets);

  /// Lets solids have colours.
  /// @param sites here, at the points of the field.
  /// @param siteColours of sites here, as SolidBodies; not used for one colour.
  void setColours(int colours, const std::vector<std::int32_t>& sites,
    const std::vector<int>& siteColours);

  /// Thins a solid.
  /// @param colour if there are several.
  /// @return what is left, on the first rank.
  std::vector<CornerCells> thin(const ThinningPart& part, Side side, int colour,
    const Checkpoint& checkpoint);

  /// Topology of the solids since select(), on the first rank.
  const CellTopology& topology() const { return topology_; }
  /// Drops what thinning alone needs.
  void finish();

private:
  bool isFirst() const { return input_.communicator.rank() == 0; }
  template <typename Work>
  void atFirst(const Work& work) const;
  std::vector<std::uint8_t> separating(const ThinningPart& part,
    const std::vector<std::int64_t>& edges) const;

  PreservationInput input_;
  std::vector<Extent> extents_;
  CornerNumbers corners_;
  ///@{
  /// Of the whole grid, on the first rank.
  std::vector<float> distances_;
  SelectedCrossings selected_;
  std::vector<std::int32_t> colourOfPoint_; ///< where there are several
  CellTopology topology_;
  ///@}
  std::vector<int> colours_; ///< all of them
};

} // namespace medial

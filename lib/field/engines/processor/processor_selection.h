#pragma once

#include "field/crossing.h"
#include "field/engines/processor/crossing_filter.h"
#include "field/engines/processor/slab_field.h"
#include "sites/grid_frame.h"

#include <functional>
#include <vector>

namespace medial
{

/// Selects crossings from sites in host memory, as medial_axis.frag does in textures. Directions
/// are computed only where the closest site changes: projection to one convex site never moves two
/// points farther apart, so it cannot give a crossing.
class ProcessorSelection
{
public:
  /// @param extent of all slabs.
  /// @param signedField whether the field has a sign, and so sides.
  /// @param filter for the displacements that process() gets, or null; must outlive this.
  ProcessorSelection(const CrossingSelection& selection, const GridFrame& frame,
    const Extent& extent, bool signedField, const CrossingFilter* filter);

  /// Returns the vector from a point to the closest point of a site, local units.
  using Displacement = std::function<glm::dvec3(int site, const glm::dvec3& x)>;

  /// Selects the crossings of a slab; slabs come in ascending z. The order of crossings does not
  /// depend on the slabs. Uses the threads of the current arena.
  /// @param displacement of the closest site of x.
  /// @throws Error as requireRoomForAxis().
  void process(const SlabField& slab, const Displacement& displacement);

  /// All crossings so far, in the order of the slabs.
  std::vector<Crossing> takeCrossings() { return std::move(crossings_); }

private:
  /// A grid point of a row, and the axis towards a neighbour with another closest site.
  struct Change
  {
    int i;
    int axis;
  };

  /// Memory of a thread.
  struct Workspace
  {
    std::vector<std::uint8_t> wanted; ///< bits of a row: which grid edges are on the wanted side
    std::vector<Change> changes;
  };

  static void findChanges(const std::int32_t* sites, const std::int32_t* ends,
    const std::uint8_t* wanted, int begin, int count, int axis, std::vector<Change>& changes);
  /// Tells which of up to eight grid edges have both ends on the wanted side, as bits.
  /// @param inside, endInside which of their ends are inside.
  unsigned wantedEdges(unsigned inside, unsigned endInside) const;
  /// Whether the crossings of a slab's last slice wait for the slice above, so that all of them
  /// come together. Those along x and y do not wait where even the thickest slabs end.
  bool waits(const Extent& slab) const;
  void selectRow(const SlabField& slab, const Displacement& displacement, int slot, int row,
    Workspace& workspace, std::vector<Crossing>& found) const;
  /// Drops edges that are not crossed, where single precision tells.
  void filter(const SlabField& slab, int slot, int row, std::vector<Change>& changes) const;
  bool crossed(const Displacement& displacement, const Crossing& crossing) const;

  double cosineLimit_;
  Side side_;
  GridFrame frame_;
  Extent extent_;
  bool signed_;
  const CrossingFilter* filter_;
  bool waited_ = false; ///< whether those of the slice below the next slab do
  std::vector<Crossing> crossings_;
};

} // namespace medial

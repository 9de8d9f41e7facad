#pragma once

#include "axis/axis_geometry.h"
#include "base/checkpoint.h"
#include "medial/ranks.h"
#include "ranks/axis/axis_patch.h"
#include "ranks/axis/corner_numbers.h"
#include "ranks/axis/kept_field.h"
#include "ranks/axis/shared_thinning.h"
#include "ranks/axis/solid_piece.h"
#include "ranks/field/field_part.h"
#include "ranks/field/grid_share.h"
#include "thinning/voxel_solid.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// An axis with the topology of its solid, as preserveTopology() makes it in one process. Ranks
/// select crossings, tell which edges curves may follow, and place the points in their parts; the
/// first rank thins (SharedThinning).
class PreservedPieces
{
public:
  /// Every rank calls it, and each of the following.
  /// @param fieldPart where this rank has computed the field, with what can be closest there; must
  ///   outlive this.
  /// @param values there.
  PreservedPieces(const PreservationInput& input, const RankPart& fieldPart, FieldPart values);

  /// Makes the points of all solids.
  /// @param geometry of the part and a halo; null for a rank without a part.
  /// @param crossings there, in the order of one process, by the smaller angle of engines.
  /// @return false on every rank if the halo is too narrow.
  bool tryHalo(const AxisGeometry* geometry, std::vector<Crossing> crossings, int halo,
    const Checkpoint& checkpoint);

  /// Takes the zigzag out of curves. Brings what can be closest around them, instead of what was
  /// here.
  void finishCurves(const Checkpoint& checkpoint);

  /// Returns the cells of this rank, without attributes but features.
  /// @param points receives those of the piece, local coordinates.
  AxisPiece piece(BisectorPoints& points) const;

private:
  /// What ranks know of the part for thinning.
  struct Part;
  struct CornerRecord;
  struct Corners;

  bool wantsSurface() const { return input_.options.representation == Representation::Surface; }

  bool addSolid(const Part& part, const ThinningPart& known, Side side);
  std::vector<CornerCells> sendCells(const std::vector<CornerCells>& cells, int halo) const;
  std::optional<Corners> cornersOf(const Part& part, const DepthField& depth,
    const std::vector<CornerCells>& cells) const;
  std::vector<CornerRecord> placed(const Part& part, const DepthField& depth,
    const std::vector<CornerCells>& cells) const;
  bool setPoints(const Part& part, const DepthField& depth, const std::vector<CornerCells>& cells,
    SolidPiece& solid) const;
  bool moveRims(const Part& part, SolidPiece& solid) const;
  AxisPatch cellsAtCurves() const;
  void tellChanges(const AxisPatch& patch);

  PreservationInput input_;
  CornerNumbers corners_;
  AxisOrder order_;
  SharedThinning thinning_;
  std::optional<KeptField> field_; ///< until the points of all solids are made
  std::vector<SolidPiece> solids_;
};

} // namespace medial

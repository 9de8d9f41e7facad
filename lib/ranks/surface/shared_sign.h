#pragma once

#include "base/checkpoint.h"
#include "base/run.h"
#include "field/field_sign.h"
#include "medial/grid.h"
#include "medial/sign_method.h"
#include "ranks/surface/distributed_surface.h"
#include "ranks/surface/shared_orientation.h"
#include "sign/closed_surface.h"
#include "sign/inside_rows.h"
#include "sign/winding_number.h"
#include "sites/grid_frame.h"

#include <memory>
#include <optional>
#include <vector>

namespace medial
{

/// The sign of the field of a distributed surface, as SignChoice chooses it in one process. Each
/// rank counts for all of them what rows pass through in its share of the triangles. The lids of
/// holes are on every rank.
class SharedSign
{
public:
  /// Chooses the method. Every rank calls it.
  /// @param surface, run must outlive this.
  /// @throws Error as SignChoice, on every rank.
  SharedSign(Communicator& communicator, const DistributedSurface& surface, SignMethod requested,
    const Grid& grid, const GridFrame& frame, const Run& run);

  const SignReport& report() const { return report_; }
  FieldSign fieldSign() const;
  /// Returns the points of an extent that are inside; the method must be Winding. Every rank calls
  /// it, with an extent of its own, which may be empty.
  InsideRows insideRows(Communicator& communicator, const Extent& extent) const;

  /// Finds out how triangles count, and closes the holes; what follows needs it. Every rank calls
  /// it.
  void close(Communicator& communicator);
  const SharedOrientation& orientation() const { return *orientation_; }
  const TriangleChain& lids() const { return lidChain_; }
  const WindingNumber* lidWinding() const { return lids_.get(); } ///< null without lids

private:
  void wind(Communicator& communicator, SignMethod requested, const Grid& grid);
  /// Makes lids on every rank.
  void makeLids(Communicator& communicator);
  double ambiguousShare(Communicator& communicator, const Grid& grid) const;
  double lidShare(Communicator& communicator) const;
  TriangleChain ownChain() const;
  /// Returns what rows pass through, lids included. Every rank calls it, with an extent of its own.
  std::vector<SliceCrossings> crossings(Communicator& communicator, const GridFrame& frame,
    const Extent& extent) const;

  const DistributedSurface& surface_;
  const Run& run_;
  Checkpoint checkpoint_;
  GridFrame frame_; ///< beside the grid
  SignReport report_;
  std::optional<SharedOrientation> orientation_;
  TriangleChain lidChain_;
  std::unique_ptr<const WindingNumber> lids_;
};

} // namespace medial

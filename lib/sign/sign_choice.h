#pragma once

#include "base/checkpoint.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/sign_method.h"
#include "medial/triangle_mesh.h"
#include "sign/closed_surface.h"
#include "sign/inside_rows.h"
#include "sign/surface_orientation.h"
#include "sign/winding_number.h"
#include "sites/grid_frame.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace medial
{

/// The sign of a mesh's field on a grid.
class SignChoice
{
public:
  /// Chooses the method. Uses the threads of the current arena.
  /// @param orienter of the mesh, whose points may have been elsewhere.
  /// @throws Error InvalidInput for Pseudonormal if the mesh is open or not consistently oriented,
  ///   and for Winding if it has no triangles; Cancelled.
  SignChoice(SignMethod requested, const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const Grid& grid, const GridFrame& frame, SurfaceOrienter& orienter,
    const Checkpoint& checkpoint);

  const SignReport& report() const { return report_; }
  /// Per triangle 1 if it faces outwards as it is, or -1. Empty without a sign.
  const std::vector<std::int8_t>& directions() const { return directions_; }
  /// Returns the points of an extent that are inside; nothing unless the method is Winding.
  std::optional<InsideRows> insideRows(const Extent& extent) const;

  ///@{
  /// What insideRows() finds the points by if the method is Winding: the closed surface, how the
  /// triangles of the mesh count there (SurfaceOrientation::weights), and where grid points are
  /// taken to be.
  const ClosedSurface& surface() const { return surface_; }
  const std::vector<std::int8_t>& weights() const { return weights_; }
  const GridFrame& frame() const { return frame_; }
  ///@}

private:
  void wind(SignMethod requested, const TriangleMesh& mesh, const SurfaceOrientation& orientation,
    const Grid& grid);

  GridFrame frame_; ///< shifted by a little
  Checkpoint checkpoint_;
  SignReport report_;
  ClosedSurface surface_;
  std::vector<std::int8_t> directions_;
  std::vector<std::int8_t> weights_;
  std::unique_ptr<WindingNumber> lids_; ///< null if there are none
};

} // namespace medial

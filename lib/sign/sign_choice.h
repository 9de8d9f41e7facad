#pragma once

#include "base/run.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/sign_method.h"
#include "medial/triangle_mesh.h"
#include "sign/closed_surface.h"
#include "sign/inside_rows.h"
#include "sign/lids.h"
#include "sign/surface_orientation.h"
#include "sites/grid_frame.h"

#include <memory>
#include <optional>

namespace medial
{

/// The sign of a mesh's field on a grid.
class SignChoice
{
public:
  /// Chooses the method. Uses the threads of the current arena.
  /// @throws Error InvalidInput for Pseudonormal if the mesh is open or not consistently oriented,
  ///   and for Winding if it has no triangles.
  SignChoice(SignMethod requested, const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const Grid& grid, const GridFrame& frame);

  const SignReport& report() const { return report_; }
  /// The mesh whose triangles face outwards; null if nothing had to be turned or the method is not
  /// Winding.
  const OrientedMesh* turnedMesh() const { return turned_ ? &*turned_ : nullptr; }
  /// Returns the points of an extent that are inside; nothing unless the method is Winding.
  std::optional<InsideRows> insideRows(const Extent& extent) const;

private:
  void wind(SignMethod requested, const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const Grid& grid);

  GridFrame frame_;
  SignReport report_;
  ClosedSurface surface_;
  std::optional<OrientedMesh> turned_;
  std::unique_ptr<Lids> lids_; ///< null if there are none
};

} // namespace medial

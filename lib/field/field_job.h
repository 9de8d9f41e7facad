#pragma once

#include "base/run.h"
#include "field/field_sign.h"
#include "field/host_inside.h"
#include "field/host_sites.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/run_statistics.h"
#include "medial/triangle_mesh.h"
#include "sites/grid_frame.h"

#include <cstddef>

namespace medial
{

/// A field to compute: a mesh in the local coordinates of a grid.
struct FieldJob
{
  const TriangleMesh& mesh;
  const MeshConnectivity& connectivity;
  const HostSites& host;
  FieldSign sign;
  const HostInside* inside; ///< grid points that are inside, if `sign` is Rows; otherwise null
  GridFrame frame;
  Extent whole;              ///< all of the grid
  Extent extent;             ///< the part of the grid to compute
  std::size_t memoryMiB;     ///< as DistanceFieldOptions::memoryMiB
  bool verify;               ///< as DistanceFieldOptions::verify
  Run run;                   ///< progress of this job
  RunStatistics& statistics; ///< engines add their seconds and counts

  /// The rows of `inside` in host memory; null if there are none.
  const InsideRows* insideRows() const { return inside != nullptr ? &inside->rows() : nullptr; }
};

} // namespace medial

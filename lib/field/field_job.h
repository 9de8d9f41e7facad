#pragma once

#include "base/run.h"
#include "culling/candidate_filter.h"
#include "field/field_sign.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/run_statistics.h"
#include "medial/triangle_mesh.h"
#include "sign/inside_rows.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace medial
{

/// A field to compute: a mesh as sites in the local coordinates of a grid.
struct FieldJob
{
  const TriangleMesh& mesh;
  const MeshConnectivity& connectivity;
  const SiteSet& sites;
  const CandidateFilter& filter;
  const std::vector<glm::vec4>& normals; ///< pseudonormals() of all sites; the processor has
                                         ///< them only if they give the sign
  FieldSign sign;
  const InsideRows* inside; ///< grid points that are inside, if `sign` is Rows; otherwise null
  GridFrame frame;
  Extent extent;             ///< the part of the grid to compute
  std::size_t memoryMiB;     ///< as DistanceFieldOptions::memoryMiB
  Run run;                   ///< progress of this job
  RunStatistics& statistics; ///< engines add their seconds and counts
};

} // namespace medial

#pragma once

#include "medial/distance_field.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

namespace medial
{

/// Computes the exact distance field of a mesh on the whole grid, with all arrays.
///
/// Linear factorisation finds the closest site of every grid point (Sud, Govindaraju, Gayle,
/// Manocha, I3D 2006, section 3): distance vectors are affine over the Voronoi region of a site.
/// The rasteriser therefore interpolates them over a polygon that bounds the region on each slice,
/// and the depth test keeps the nearest. The processor evaluates the same affine functions tile by
/// tile. Both then compute exact distances from the closest sites.
///
/// @throws Error InvalidInput (empty mesh, bad grid, impossible sign; a mesh or grid that reaches
///   farther than 1e18 times the finest spacing from the middle of the grid; with the rasteriser,
///   grid points that may be farther than 32768 times that spacing from the mesh), NoGpu and
///   GpuLimit (with the rasteriser or requireHardware), OutOfMemory, Cancelled.
MEDIAL_EXPORT DistanceField computeDistanceField(const TriangleMesh& mesh, const Grid& grid,
  const DistanceFieldOptions& options = {});

/// Computes the part of the field inside `extent` and writes it to the caller's arrays. Values do
/// not depend on the extent (ids may, between sites at equal distance).
/// @throws Error as computeDistanceField, and InvalidInput if the extent is empty or exceeds the
///   grid.
MEDIAL_EXPORT RunStatistics computeDistanceField(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const Extent& extent,
  const FieldArrays& arrays, const DistanceFieldOptions& options = {});

/// The same, delivered slab by slab. Exceptions of the sink end the run and reach the caller.
MEDIAL_EXPORT RunStatistics computeDistanceField(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const Extent& extent, FieldSink& sink,
  const DistanceFieldOptions& options = {});

} // namespace medial

#pragma once

#include "medial/compute_medial_axis.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/skeleton.h"
#include "medial/triangle_mesh.h"

#include <optional>

namespace medial
{

/// Smallest resolution that chooseSkeletonResolution() returns.
constexpr int kMinSkeletonResolution = 128;
/// Largest resolution that chooseSkeletonResolution() returns.
constexpr int kMaxSkeletonResolution = 512;

/// A resolution for a skeleton, and why.
struct SkeletonResolution
{
  /// In [kMinSkeletonResolution, kMaxSkeletonResolution].
  int resolution = kMinSkeletonResolution;
  /// What the thinnest branch needs, >= 2. If it is larger than `resolution`, thin branches may be
  /// missing.
  int needed = 2;
  /// Radius of the thinnest branch that was found, world units; infinity if there is none.
  double thinnestRadius = 0.0;
  /// The skeleton at `resolution`, if it was made to find out that this is enough.
  std::optional<Skeleton> skeleton;
  std::optional<MedialAxis> axis; ///< the one of `skeleton`
};

/// Returns the smallest resolution at which grid points are closer together than a quarter of the
/// radius of the thinnest branch of a skeleton; in [kMinResolution, kMaxDimension].
/// @param bounds, padding as for makeGrid().
/// @throws Error InvalidInput as makeGrid().
MEDIAL_EXPORT int neededResolution(const Skeleton& skeleton, const Bounds& bounds,
  double padding = kDefaultPadding);

/// Finds the resolution that the skeleton of a mesh needs. It computes skeletons on coarse grids,
/// beginning with kMinSkeletonResolution points along the longest axis and doubling them as long as
/// the thinnest branch needs more than four times as many. Branches with a radius below the
/// distance of points of the first grid, which it may not show, are not looked for.
/// @param axisOptions Topology::Preserve is taken whatever they say.
/// @param padding as for makeGrid().
/// @throws Error as makeGrid(), computeMedialAxis() and computeSkeleton(), but not where no grid
///   point is inside.
MEDIAL_EXPORT SkeletonResolution chooseSkeletonResolution(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const MedialAxisOptions& axisOptions = {},
  const SkeletonOptions& skeletonOptions = {}, double padding = kDefaultPadding);

} // namespace medial

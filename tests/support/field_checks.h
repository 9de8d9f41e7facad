#pragma once

#include "medial/distance_field.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Compares distance fields with the brute-force oracle and with each other.
namespace medial::test
{

struct MeshOnGrid
{
  TriangleMesh mesh;
  Grid grid;
};

/// Voxels, that is points, of a field: indices into its arrays.
using Voxels = std::vector<std::size_t>;

Voxels allVoxels(const Grid& grid);

/// `count` voxels, uniformly random; the same for the same seed. All voxels where there are fewer.
Voxels randomVoxels(const Grid& grid, std::size_t count, std::uint32_t seed = 1);

Point3 voxelPoint(const Grid& grid, std::size_t voxel);

/// The finest spacing: lengths below are in this unit.
double voxelSize(const Grid& grid);

/// How far a field is from the truth at some voxels. Lengths in voxels.
struct FieldErrors
{
  std::size_t voxels = 0;
  std::size_t withoutSite = 0;  ///< closest site outside [0, number of sites)
  std::size_t wrongFeature = 0; ///< feature that is not the kind of the closest site
  std::size_t inexact = 0;      ///< distance more than 1e-3 wrong
  double distance = 0.0;        ///< maximum error of abs(Distance)
  double site = 0.0;            ///< maximum excess of the distance to the closest site
  double pointLength = 0.0;     ///< maximum difference of |ClosestPoint - voxel| and the distance
  double pointFromCell = 0.0;   ///< maximum distance of ClosestPoint from ClosestCell
  std::size_t worst = 0;        ///< the voxel of the maximum `distance`
  double rounding = 0.0;        ///< what storing ClosestPoint in single precision may add

  std::string describe() const;
};

FieldErrors fieldErrors(const TriangleMesh& mesh, const DistanceField& field, const Voxels& voxels);

/// Expects a field to be exact within the tolerances: errors of at most 1e-2 voxel everywhere and
/// 1e-3 at 99.99 % of the voxels, true minimisers, closest points on their cells.
void expectExact(const TriangleMesh& mesh, const DistanceField& field, const Voxels& voxels);

/// The same options for every engine.
std::vector<DistanceFieldOptions> allEngines(const DistanceFieldOptions& options = {});
/// The same but for the device where it would take long: on a large grid without a GPU.
std::vector<DistanceFieldOptions> enginesFor(const Grid& grid,
  const DistanceFieldOptions& options = {});

/// Computes a field by all engines and checks it at some voxels.
void expectExactField(const TriangleMesh& mesh, const Grid& grid, const Voxels& voxels);
/// At every voxel.
void expectExactField(const TriangleMesh& mesh, const Grid& grid,
  const DistanceFieldOptions& options = {});

/// Overwrites the distances and sites of `field` inside `extent` with those of a computation of
/// that part alone.
void computePart(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Extent& extent, DistanceField& field);

/// How two fields over the same number of voxels differ.
struct FieldDifference
{
  double distance = 0.0;       ///< maximum, in voxels of the first field, signs included
  std::size_t sites = 0;       ///< voxels with different sites
  std::size_t untiedSites = 0; ///< those whose sites the mesh has at different distances
};

FieldDifference difference(const TriangleMesh& mesh, const DistanceField& a,
  const DistanceField& b);

} // namespace medial::test

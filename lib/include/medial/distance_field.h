#pragma once

#include "medial/engine.h"
#include "medial/execution.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/run_statistics.h"
#include "medial/sign_method.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Kind of the closest site, as stored in the ClosestFeature array.
enum class Feature : std::uint8_t
{
  Vertex = 0,
  Edge = 1,
  Face = 2
};

/// How a distance field is computed.
struct DistanceFieldOptions
{
  SignMethod sign = SignMethod::Auto; ///< how to tell inside from outside
  Engine engine = Engine::Auto;       ///< what finds the closest sites
  /// Memory in MiB that the slabs in progress should not exceed, on the host and on the device
  /// each; 0 lets the library choose. Sites, candidates and the caller's arrays come on top. A slab
  /// has at least one slice.
  std::size_t memoryMiB = 0;
  /// Fail without OpenGL or with a software renderer, whatever the engine.
  bool requireHardware = false;
  Execution execution; ///< threads, progress and cancelling
};

/// The arrays that receive results. Each has one element (closestPoint: three) per point of the
/// extent, x fastest. A null pointer means that the array is not wanted.
struct FieldArrays
{
  float* distance = nullptr;              ///< world units; negative inside unless unsigned
  float* closestPoint = nullptr;          ///< world coordinates, xyz
  std::int32_t* closestSite = nullptr;    ///< in [0, F+E+V): faces, then edges, then vertices
  std::uint8_t* closestFeature = nullptr; ///< a value of Feature
  std::int64_t* closestCell = nullptr;    ///< id of an input cell that contains the closest site

  /// Whether any array is wanted.
  bool any() const
  {
    return distance || closestPoint || closestSite || closestFeature || closestCell;
  }
};

/// Receives a field slab by slab in ascending z, for grids that do not fit into memory.
class FieldSink
{
public:
  virtual ~FieldSink() = default;

  /// Returns the arrays that receive the values of a slab, with one element (closestPoint: three)
  /// per point of `slab`. The same arrays must be wanted for every slab, and they must stay valid
  /// until stored(slab). There is one slab at a time. This function, like the other members, is
  /// called on the thread that runs the computation.
  virtual FieldArrays slabArrays(const Extent& slab) = 0;
  /// Called when all values of the slab have been written.
  virtual void stored(const Extent& slab) = 0;
  /// Bytes that the sink holds per point of a slab; they count towards
  /// DistanceFieldOptions::memoryMiB.
  virtual std::size_t bytesPerPoint() const = 0;
};

/// A distance field in memory. Each array has one element (closestPoint: three) per grid point, x
/// fastest.
struct DistanceField
{
  Grid grid;                                ///< the grid of the field
  SignMethod sign = SignMethod::None;       ///< the method used, never Auto
  std::vector<float> distance;              ///< as FieldArrays::distance
  std::vector<float> closestPoint;          ///< as FieldArrays::closestPoint
  std::vector<std::int32_t> closestSite;    ///< as FieldArrays::closestSite
  std::vector<std::uint8_t> closestFeature; ///< as FieldArrays::closestFeature
  std::vector<std::int64_t> closestCell;    ///< as FieldArrays::closestCell
  RunStatistics statistics;                 ///< times and counts of the computation
};

/// Computes the exact distance field of a mesh on the whole grid, with all arrays.
///
/// Linear factorisation finds the closest site of every grid point (Sud, Govindaraju, Gayle,
/// Manocha, I3D 2006, section 3): distance vectors are affine over the Voronoi region of a site.
/// The rasteriser therefore interpolates them over a polygon that bounds the region on each slice,
/// and the depth test keeps the nearest. The processor evaluates the same affine functions tile by
/// tile. Both then compute exact distances from the closest sites.
///
/// @throws Error InvalidInput (empty mesh, bad grid, impossible sign), NoGpu and GpuLimit (with the
///   rasteriser or requireHardware), OutOfMemory, Cancelled.
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

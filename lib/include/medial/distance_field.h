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
  SignMethod sign = SignMethod::Auto; ///< how inside is told from outside
  Engine engine = Engine::Auto;       ///< what finds the closest sites
  /// What the slabs that are in work at a time should not exceed, in MiB, on the device as on the
  /// host; 0 chooses. Sites, candidates, and arrays that the caller holds come on top. A slab has
  /// at least one slice.
  std::size_t memoryMiB = 0;
  /// Fail without OpenGL and on a software renderer, whatever the engine.
  bool requireHardware = false;
  Execution execution; ///< threads, progress and cancelling
};

/// Where results go: each array has one element (closestPoint: three) per point of the extent, x
/// fastest. A null pointer means that the array is not wanted.
struct FieldArrays
{
  float* distance = nullptr;              ///< world units; negative inside unless unsigned
  float* closestPoint = nullptr;          ///< world coordinates, xyz
  std::int32_t* closestSite = nullptr;    ///< faces, edges, vertices in this order: [0, F+E+V)
  std::uint8_t* closestFeature = nullptr; ///< Feature
  std::int64_t* closestCell = nullptr;    ///< id of an input cell that holds the closest site

  /// Whether any array is wanted.
  bool any() const
  {
    return distance || closestPoint || closestSite || closestFeature || closestCell;
  }
};

/// Receives a field slab by slab in ascending z, for grids that memory cannot hold.
class FieldSink
{
public:
  virtual ~FieldSink() = default;

  /// Asks where the values of a slab are to be written: arrays with one element per point of
  /// `slab`, the same ones for every slab, valid until stored(slab). One slab at a time; called on
  /// the thread that runs the computation, as all members.
  virtual FieldArrays slabArrays(const Extent& slab) = 0;
  /// All values of the slab have been written.
  virtual void stored(const Extent& slab) = 0;
  /// Bytes that the sink holds per point of a slab; they count towards the memory of slabs.
  virtual std::size_t bytesPerPoint() const = 0;
};

/// A distance field in memory: arrays with one element (closestPoint: three) per grid point, x
/// fastest.
struct DistanceField
{
  Grid grid;                                ///< where the samples are
  SignMethod sign = SignMethod::None;       ///< the method used, never Auto
  std::vector<float> distance;              ///< as FieldArrays::distance
  std::vector<float> closestPoint;          ///< as FieldArrays::closestPoint
  std::vector<std::int32_t> closestSite;    ///< as FieldArrays::closestSite
  std::vector<std::uint8_t> closestFeature; ///< as FieldArrays::closestFeature
  std::vector<std::int64_t> closestCell;    ///< as FieldArrays::closestCell
  RunStatistics statistics;                 ///< what computing it took
};

/// Exact distance field of a mesh on the whole grid, with all arrays.
///
/// The closest site of every grid point is found by linear factorisation (Sud, Govindaraju, Gayle,
/// Manocha, I3D 2006, section 3): distance vectors are affine over a site's Voronoi region, so the
/// rasteriser interpolates them over a polygon that bounds the region on each slice and the depth
/// test keeps the nearest. Distances are then evaluated exactly from the closest site. The
/// processor evaluates the same affine functions tile by tile.
///
/// @throws Error InvalidInput (empty mesh, bad grid, impossible sign), NoGpu and GpuLimit (with the
///   rasteriser or requireHardware), OutOfMemory, Cancelled.
MEDIAL_EXPORT DistanceField computeDistanceField(const TriangleMesh& mesh, const Grid& grid,
  const DistanceFieldOptions& options = {});

/// The part of the field inside `extent`, written to the caller's arrays. Values do not depend on
/// the extent (ids: except between sites at equal distance).
/// @throws Error as computeDistanceField, and InvalidInput when the extent is empty or leaves the
/// grid.
MEDIAL_EXPORT RunStatistics computeDistanceField(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const Extent& extent,
  const FieldArrays& arrays, const DistanceFieldOptions& options = {});

/// The same, delivered slab by slab. Exceptions of the sink end the run and are passed on.
MEDIAL_EXPORT RunStatistics computeDistanceField(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const Extent& extent, FieldSink& sink,
  const DistanceFieldOptions& options = {});

} // namespace medial

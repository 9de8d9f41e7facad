#pragma once

#include "medial/common/grid.h"
#include "medial/common/progress.h"
#include "medial/gpu/device.h"
#include "medial/mesh/topology.h"
#include "medial/mesh/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// How inside is told from outside. Negative is inside; the magnitude never depends on the method.
enum class SignMethod
{
  Auto,         ///< Pseudonormal for closed, consistently oriented meshes, else None
  None,         ///< unsigned distance
  Pseudonormal, ///< angle-weighted pseudonormals; the mesh must be closed and oriented
  Winding       ///< generalised winding number; not available yet
};

/// Kind of the closest site, as stored in the ClosestFeature array.
enum class Feature : std::uint8_t
{
  Vertex = 0,
  Edge = 1,
  Face = 2
};

/// What finds the closest sites. All give the same field (ids: except between sites at equal
/// distance), at different speed.
enum class Evaluator
{
  Auto,       ///< Processor where OpenGL runs on a software renderer, else Rasteriser
  Rasteriser, ///< draws polygons that bound Voronoi regions, with OpenGL's depth test
  Processor   ///< evaluates the candidates of every tile with vector instructions of the CPU
};

/// How a distance field is computed.
struct DistanceFieldOptions
{
  SignMethod sign = SignMethod::Auto;    ///< how inside is told from outside
  Evaluator evaluator = Evaluator::Auto; ///< what finds the closest sites
  /// CPU threads to use; 0 for all cores.
  int threads = 0;
  /// What the slabs that are in work at a time should not exceed, in MiB, on the device as on the
  /// host; 0 chooses. Sites, candidates, and arrays that the caller holds come on top. A slab has
  /// at least one slice.
  std::size_t memoryMiB = 0;
  /// Fail on a software renderer.
  bool requireHardware = false;
  /// Told of progress and asked for cancellation; may be null.
  Progress* progress = nullptr;
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

/// What a run did and how long each phase took.
struct RunStatistics
{
  /// Wall-clock seconds.
  struct Seconds
  {
    double sites = 0;    ///< building sites and their half-spaces
    double cull = 0;     ///< hierarchical candidates
    double polygons = 0; ///< clipping bounds of Voronoi regions
    double draw = 0;     ///< upload and rasterisation; or evaluation by the processor
    double resolve = 0;  ///< exact distances from closest sites, read-back
    double medial = 0;   ///< direction field, selection, medial surface
  };
  Seconds seconds;                 ///< of each phase
  std::int64_t sites = 0;          ///< faces, edges and vertices of the mesh
  std::int64_t candidatePairs = 0; ///< (site, leaf tile) pairs that survive culling
  std::int64_t polygons = 0;       ///< drawn; 0 with the processor
  /// Polygon area in samples, before the depth test; or pairs of samples and sites that the
  /// processor evaluated.
  std::int64_t fragments = 0;
  std::int64_t samples = 0; ///< grid points computed
  Device device;            ///< the OpenGL implementation, also where the processor evaluates
  Evaluator evaluator = Evaluator::Auto; ///< what was used, never Auto

  /// Fragments over samples; 0 where there are none.
  double fragmentsPerVoxel() const
  {
    return samples > 0 ? static_cast<double>(fragments) / static_cast<double>(samples) : 0.0;
  }
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

/// The sign method that `requested` means for a mesh.
/// @throws Error InvalidInput for Winding, and for Pseudonormal where the mesh is open or not
///   consistently oriented.
SignMethod resolveSignMethod(SignMethod requested, const MeshTopology& topology);

/// Exact distance field of a mesh on the whole grid, with all arrays.
///
/// The closest site of every grid point is found by linear factorisation (Sud, Govindaraju, Gayle,
/// Manocha, I3D 2006, section 3): distance vectors are affine over a site's Voronoi region, so the
/// rasteriser interpolates them over a polygon that bounds the region on each slice and the depth
/// test keeps the nearest. Distances are then evaluated exactly from the closest site. Where there
/// is no graphics hardware the processor evaluates the same affine functions tile by tile.
///
/// @throws Error InvalidInput (empty mesh, bad grid, impossible sign), NoGpu, GpuLimit,
///   OutOfMemory, Cancelled.
DistanceField computeDistanceField(const TriangleMesh& mesh, const Grid& grid,
  const DistanceFieldOptions& options = {});

/// The part of the field inside `extent`, written to the caller's arrays. Values do not depend on
/// the extent (ids: except between sites at equal distance).
/// @throws Error as computeDistanceField, and InvalidInput when the extent is empty or leaves the
/// grid.
RunStatistics computeDistanceField(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const Extent& extent, const FieldArrays& arrays,
  const DistanceFieldOptions& options = {});

/// The same, delivered slab by slab. Exceptions of the sink end the run and are passed on.
RunStatistics computeDistanceField(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const Extent& extent, FieldSink& sink,
  const DistanceFieldOptions& options = {});

} // namespace medial

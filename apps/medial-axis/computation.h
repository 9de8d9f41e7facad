#pragma once

#include "input/surface.h"
#include "options.h"
#include "progress_bar.h"
#include "volumes/field_output.h"

#include "medial/axis_coverage.h"
#include "medial/compute_medial_axis.h"
#include "medial/local_thickness.h"
#include "medial/mesh_connectivity.h"
#include "medial/ranks.h"
#include "medial/skeleton.h"
#include "medial/skeleton_resolution.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"
#include "medial/triangle_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace medial::app
{

/// A note tells the user if the axis leaves out this share of the surface or more.
constexpr double kNoticeableShare = 0.01;

/// What a report states of a mesh.
struct MeshFigures
{
  std::size_t triangles = 0;
  std::size_t points = 0; ///< welded
  std::int64_t components = 0;
  std::int64_t degenerateTriangles = 0;
  bool closed = false;
  bool manifold = false;
  double diagonal = 0.0; ///< of the bounds, world units
};

/// What one of several processes has had to do.
struct RankFigures
{
  RankCounts counts;
  std::int64_t gridPoints = 0; ///< of its part
  std::int64_t axisCells = 0;
  double peakMemoryMiB = 0.0;
};

/// What a run computes, and what it computes it from.
struct Result
{
  MeshFigures meshFigures;
  /// Of a single process, like its connectivity; of several, the triangles beyond limits.
  TriangleMesh mesh;
  MeshConnectivity connectivity;
  Grid grid;
  std::optional<SkeletonResolution> chosenResolution; ///< with --resolution auto
  SignMethod sign = SignMethod::None;                 ///< never Auto
  RunStatistics statistics;
  MedialAxis axis; ///< empty where it is not wanted; no cells of several processes
  std::int64_t axisPoints = 0;
  std::int64_t axisCells = 0;
  CellTopology axisTopology;            ///< where a report is wanted
  std::optional<AxisCoverage> coverage; ///< of an interior axis, for report or summary
  /// How thick the solid is at the coverage's places, world units, NaN where nothing is opposite.
  std::vector<double> placeThickness;
  std::optional<Subdivision> fineMesh;           ///< with --max-edge, for thickness
  std::optional<Thickness> thickness;            ///< of fineMesh or mesh, where it is wanted
  std::int64_t thicknessTriangles = 0;           ///< of the surface that it is of
  std::vector<ThicknessRegion> regions;          ///< beyond the limits of thickness
  vtkSmartPointer<vtkPolyData> thicknessSurface; ///< with the values, where it is wanted
  vtkSmartPointer<vtkPolyData> thicknessPicture; ///< the same with enough points for a picture
  std::optional<Skeleton> skeleton;              ///< where it is wanted
  std::optional<LocalThicknessStatistics> localThickness; ///< where it is wanted
  double measureSeconds = 0.0;                            ///< that topology and coverage took
  /// Of an axis and a skeleton that were made to choose the resolution and are taken as they are.
  double takenSeconds = 0.0;
  std::vector<RankFigures> ranks; ///< of several processes

  /// The grid's spacing that catches the walls that its own misses at these places; nothing if it
  /// is fine enough for them, or if the options leave them out at any spacing.
  std::optional<double> catchingSpacing(const Options& options) const;

  /// The mesh that thickness is of.
  const TriangleMesh& thicknessMesh() const { return fineMesh ? fineMesh->mesh : mesh; }
};

/// Longest edge of the surface whose thickness is computed, world units; 0 leaves it as it is.
/// @param diagonal of the mesh's bounds.
double maxThicknessEdge(const Options& options, double diagonal);

/// @throws Failure Usage for limits of thickness that contradict each other.
void requireLimits(const ThicknessLimits& limits);

/// The grid around a mesh, where the options tell it.
/// @throws Error InvalidInput.
Grid gridOf(const Bounds& bounds, const Options& options);

MeshFigures figuresOf(const TriangleMesh& mesh, const MeshConnectivity& connectivity);

/// Measures what a report states. Only for the note in the summary, a bound on fewer samples is
/// enough unless the share may be noticeable.
/// @param measure measures with a number of samples and a negligible share.
AxisCoverage coverageFor(const Options& options,
  const std::function<AxisCoverage(std::int64_t samples, double negligible)>& measure);

/// Whether coverage is to be measured, for a report or a note.
bool wantsCoverage(const Options& options, Side side);

/// How far the axis may be from the surface that counts as covered: a voxel's diagonal.
double coverageReach(const Grid& grid);

/// Thickness along rays at the middles of the cells nearest to places.
std::vector<double> thicknessAt(const std::vector<UncoveredPlace>& places, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Execution& execution);

/// The mesh as the filters see it, and its grid, which with --resolution auto takes skeletons.
/// @throws Failure.
Result prepare(const Surface& surface, const Options& options, ProgressBar& bar);

/// Computes the axis, if an option asks for it, and the field, which goes to disk meanwhile, in one
/// pass over the grid. Does nothing if neither is wanted, and leaves a field without an axis to
/// computeLocalThickness() if that is wanted.
/// @param field null if it is not wanted.
/// @throws Failure.
void compute(const Options& options, FieldOutput* field, ProgressBar& bar, Result& result);

/// Computes the skeleton from the axis, if an option asks for it.
/// @throws Failure.
void computeSkeleton(const Options& options, ProgressBar& bar, Result& result);

/// Computes local thickness, which goes to disk meanwhile. Does nothing if it is not wanted.
/// @param image null if it is not wanted.
/// @param field where the distance field goes, which compute() then leaves out; null if it is not
///   wanted.
/// @throws Failure.
void computeLocalThickness(const Options& options, FieldOutput* image, FieldOutput* field,
  ProgressBar& bar, Result& result);

/// Computes the thickness, as far as options ask for it.
/// @param surface the one that the mesh of the result was made from.
/// @throws Failure; Usage for limits that contradict each other.
void computeThickness(const Options& options, Surface& surface, ProgressBar& bar, Result& result);

} // namespace medial::app

#pragma once

#include "field_output.h"
#include "options.h"
#include "progress_bar.h"
#include "surface.h"

#include "medial/axis_coverage.h"
#include "medial/compute_medial_axis.h"
#include "medial/local_thickness.h"
#include "medial/mesh_connectivity.h"
#include "medial/skeleton.h"
#include "medial/skeleton_resolution.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"
#include "medial/triangle_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

namespace medial::app
{

/// A note tells the user if the axis leaves out this share of the surface or more.
constexpr double kNoticeableShare = 0.01;

/// What a run computes, and what it computes it from.
struct Result
{
  TriangleMesh mesh;
  MeshConnectivity connectivity;
  Grid grid;
  std::optional<SkeletonResolution> chosenResolution; ///< with --resolution auto
  SignMethod sign = SignMethod::None;                 ///< never Auto
  RunStatistics statistics;
  MedialAxis axis;                      ///< empty where it is not wanted
  CellTopology axisTopology;            ///< where a report is wanted
  std::optional<AxisCoverage> coverage; ///< of an interior axis, for report or summary
  /// How thick the solid is at the coverage's places, world units, NaN where nothing is opposite.
  std::vector<double> placeThickness;
  std::optional<Subdivision> fineMesh;           ///< with --max-edge, for thickness
  std::optional<Thickness> thickness;            ///< of fineMesh or mesh, where it is wanted
  std::vector<ThicknessRegion> regions;          ///< beyond the limits of thickness
  vtkSmartPointer<vtkPolyData> thicknessSurface; ///< with the values, where it is wanted
  vtkSmartPointer<vtkPolyData> thicknessPicture; ///< the same with enough points for a picture
  std::optional<Skeleton> skeleton;              ///< where it is wanted
  std::optional<LocalThicknessStatistics> localThickness; ///< where it is wanted
  double measureSeconds = 0.0;                            ///< that topology and coverage took

  /// The grid's spacing that catches the walls that its own misses at these places; nothing if it
  /// is fine enough for them, or if the options leave them out at any spacing.
  std::optional<double> catchingSpacing(const Options& options) const;

  /// The mesh that thickness is of.
  const TriangleMesh& thicknessMesh() const { return fineMesh ? fineMesh->mesh : mesh; }
};

/// The grid around a mesh, where the options tell it.
/// @throws Error InvalidInput.
Grid gridOf(const Bounds& bounds, const Options& options);

/// The mesh as the filters see it, and its grid, which with --resolution auto takes skeletons.
/// @throws Failure.
Result prepare(const Surface& surface, const Options& options, ProgressBar& bar);

/// Computes the axis, if an option asks for it, and the field, which goes to disk meanwhile, in one
/// pass over the grid. Does nothing if neither is wanted.
/// @param field null if it is not wanted.
/// @throws Failure.
void compute(const Options& options, FieldOutput* field, ProgressBar& bar, Result& result);

/// Computes the skeleton from the axis, if an option asks for it.
/// @throws Failure.
void computeSkeleton(const Options& options, ProgressBar& bar, Result& result);

/// Computes local thickness, which goes to disk meanwhile. Does nothing if it is not wanted.
/// @param image null if it is not wanted.
/// @throws Failure.
void computeLocalThickness(const Options& options, FieldOutput* image, ProgressBar& bar,
  Result& result);

/// Computes the thickness, as far as options ask for it.
/// @param surface the one that the mesh of the result was made from.
/// @throws Failure; Usage for limits that contradict each other.
void computeThickness(const Options& options, Surface& surface, ProgressBar& bar, Result& result);

} // namespace medial::app

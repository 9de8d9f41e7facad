#pragma once

#include "medial/axis_coverage.h"
#include "medial/cell_topology.h"
#include "medial/compute_medial_axis.h"
#include "medial/grid.h"
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
#include <optional>
#include <vector>

namespace medial::app
{

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

/// What a report states of a mesh in one piece.
MeshFigures figuresOf(const TriangleMesh& mesh, const MeshConnectivity& connectivity);

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

  /// The mesh that thickness is of.
  const TriangleMesh& thicknessMesh() const { return fineMesh ? fineMesh->mesh : mesh; }
};

} // namespace medial::app

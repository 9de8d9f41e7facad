#pragma once

#include "options.h"
#include "progress_bar.h"

#include "medial/axis_coverage.h"
#include "medial/compute_medial_axis.h"
#include "medial/mesh_connectivity.h"
#include "medial/thickness.h"
#include "medial/triangle_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

namespace medial::app
{

/// What a run computes, and from what.
struct Result
{
  TriangleMesh mesh;
  MeshConnectivity connectivity;
  Grid grid;
  SignMethod sign = SignMethod::None; ///< never Auto
  Side side = Side::Both;             ///< of the axis
  RunStatistics statistics;
  SimplificationStatistics simplification;   ///< all 0 without --max-spheres
  CellTopology axisTopology;                 ///< where a report is wanted
  std::optional<CellTopology> solidTopology; ///< where the axis preserves it
  std::optional<AxisCoverage> coverage;      ///< of an interior axis, unless nobody is told
  vtkSmartPointer<vtkPolyData> axis;   ///< as vtkMedialAxis makes it; empty where it is not wanted
  vtkSmartPointer<vtkPolyData> curves; ///< of the axis, as vtkMedialCurves makes them, where wanted
  std::optional<Thickness> thickness;  ///< of the mesh's points, where it is wanted
  vtkSmartPointer<vtkPolyData> thicknessPicture; ///< pictureOfThickness(), where it is wanted
  std::vector<std::string> pageNotes;            ///< what --html has simplified
};

/// The mesh as the filters see it, and its grid.
/// @throws Failure BadInput.
Result prepare(vtkPolyData* mesh, const Options& options);

/// Fills in what follows from mesh and grid: the axis where an option asks for it, and the field
/// where there is a sink for it, in one pass over the grid; nothing where neither is wanted.
/// @param field may be null. Its exceptions are passed on.
/// @throws Failure.
void compute(const Options& options, FieldSink* field, ProgressBar& bar, Result& result);

/// Fills in what is wanted of the thickness.
/// @param surface what the mesh of the result was made from.
/// @throws Failure.
void computeThickness(const Options& options, vtkPolyData* surface, ProgressBar& bar,
  Result& result);

} // namespace medial::app

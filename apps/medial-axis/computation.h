#pragma once

#include "field_output.h"
#include "options.h"
#include "progress_bar.h"
#include "surface.h"

#include "medial/axis_coverage.h"
#include "medial/compute_medial_axis.h"
#include "medial/mesh_connectivity.h"
#include "medial/thickness.h"
#include "medial/triangle_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>

namespace medial::app
{

/// What a run computes, and from what.
struct Result
{
  TriangleMesh mesh;
  MeshConnectivity connectivity;
  Grid grid;
  SignMethod sign = SignMethod::None; ///< never Auto
  RunStatistics statistics;
  MedialAxis axis;                      ///< empty where it is not wanted
  CellTopology axisTopology;            ///< where a report is wanted
  std::optional<AxisCoverage> coverage; ///< of an interior axis, where report or summary has it
  std::optional<Thickness> thickness;   ///< of the mesh's points, where it is wanted
  vtkSmartPointer<vtkPolyData> thicknessPicture; ///< pictureOfThickness(), where it is wanted
};

/// The mesh as the filters see it, and its grid.
/// @throws Failure BadInput.
Result prepare(const Surface& surface, const Options& options);

/// Fills in what follows from mesh and grid, in one pass over the grid: the axis where an option
/// asks for it, and the field, which goes to disk meanwhile; nothing where neither is wanted.
/// @param field null where it is not wanted.
/// @throws Failure.
void compute(const Options& options, FieldOutput* field, ProgressBar& bar, Result& result);

/// Fills in what is wanted of the thickness.
/// @param surface what the mesh of the result was made from.
/// @throws Failure.
void computeThickness(const Options& options, Surface& surface, ProgressBar& bar, Result& result);

} // namespace medial::app

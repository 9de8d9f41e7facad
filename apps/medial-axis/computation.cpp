#include "computation.h"

#include "interrupt.h"
#include "library_calls.h"
#include "surface_thickness.h"

#include <vtkMedialCurves.h>
#include <vtkMeshConversion.h>
#include <vtkNew.h>

#include <cmath>

namespace medial::app
{
namespace
{

Grid gridOf(const Bounds& bounds, const Options& options)
{
  if (options.spacing)
  {
    const double spacing = *options.spacing;
    return makeGridWithSpacing(bounds, { spacing, spacing, spacing }, options.padding);
  }
  return makeGrid(bounds, options.resolution, options.padding);
}

void computeField(const DistanceFieldOptions& options, FieldSink& field, Result& result)
{
  result.statistics = computeDistanceField(result.mesh, result.connectivity, result.grid,
    result.grid.wholeExtent(), field, options);
  result.sign = resolveSignMethod(options.sign, result.connectivity);
}

double voxelDiagonal(const Grid& grid)
{
  return std::hypot(grid.spacing[0], grid.spacing[1], grid.spacing[2]);
}

AxisCoverage coverageOf(const MedialAxis& axis, const Result& result,
  const DistanceFieldOptions& options)
{
  CoverageOptions wanted;
  wanted.execution = options.execution;
  return measureCoverage(result.mesh, toMedialModel(axis), voxelDiagonal(result.grid), wanted);
}

vtkSmartPointer<vtkPolyData> curvesOf(vtkPolyData* axis)
{
  vtkNew<vtkMedialCurves> curves;
  curves->SetInputData(axis);
  curves->Update();
  return curves->GetOutput();
}

void computeAxis(const Options& told, const MedialAxisOptions& options, FieldSink* field,
  Result& result)
{
  const MedialAxis axis = field != nullptr
    ? computeMedialAxis(result.mesh, result.connectivity, result.grid, options, *field)
    : computeMedialAxis(result.mesh, result.connectivity, result.grid, options);
  vtkMeshConversion::ToPolyData(axis, result.axis);
  result.statistics = axis.statistics;
  result.simplification = axis.simplification;
  result.sign = axis.sign;
  result.side = axis.side;
  result.solidTopology = axis.solid;
  if (!told.curves.empty())
  {
    result.curves = curvesOf(result.axis);
  }
  if (!told.report.empty())
  {
    result.axisTopology = topologyOf(axis);
  }
  if (axis.side == Side::Interior && (!told.report.empty() || !told.quiet))
  {
    result.coverage = coverageOf(axis, result, options.field);
  }
}

} // namespace

Result prepare(vtkPolyData* mesh, const Options& options)
{
  Result result;
  withFailures(options.input,
    [&]
    {
      result.axis = vtkSmartPointer<vtkPolyData>::New();
      result.mesh = buildTriangleMesh(vtkMeshConversion::ToMeshInput(mesh));
      result.connectivity = analyseConnectivity(result.mesh);
      result.grid = gridOf(result.mesh.bounds(), options);
    });
  return result;
}

void compute(const Options& options, FieldSink* field, ProgressBar& bar, Result& result)
{
  Watch watch(bar);
  MedialAxisOptions wanted = libraryOptions(options, result.mesh.bounds().diagonal());
  wanted.field.execution.progress = &watch;
  withFailures(options.input,
    [&]
    {
      if (options.wantsAxis())
      {
        computeAxis(options, wanted, field, result);
      }
      else if (field != nullptr)
      {
        computeField(wanted.field, *field, result);
      }
    });
  throwIfInterrupted();
}

void computeThickness(const Options& options, vtkPolyData* surface, ProgressBar& bar,
  Result& result)
{
  Watch watch(bar);
  ThicknessOptions wanted = thicknessOptions(options);
  wanted.execution.progress = &watch;
  withFailures(options.input,
    [&]
    {
      if (options.wantsThickness())
      {
        result.thickness = computeThickness(result.mesh, result.connectivity, wanted);
      }
      if (!options.thicknessImage.empty())
      {
        result.thicknessPicture = pictureOfThickness(surface, wanted);
      }
    });
  throwIfInterrupted();
}

} // namespace medial::app

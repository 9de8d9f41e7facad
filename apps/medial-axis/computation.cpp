#include "computation.h"

#include "interrupt.h"
#include "library_calls.h"
#include "surface_thickness.h"

#include <vtkMeshConversion.h>

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
  result.statistics = computeDistanceField(result.mesh, result.topology, result.grid,
    result.grid.wholeExtent(), field, options);
  result.sign = resolveSignMethod(options.sign, result.topology);
}

void computeAxis(const MedialAxisOptions& options, bool reported, FieldSink* field, Result& result)
{
  const MedialAxis axis = field != nullptr
    ? computeMedialAxis(result.mesh, result.topology, result.grid, options, *field)
    : computeMedialAxis(result.mesh, result.topology, result.grid, options);
  vtkMeshConversion::ToPolyData(axis, result.axis);
  result.statistics = axis.statistics;
  result.simplification = axis.simplification;
  result.sign = axis.sign;
  result.side = axis.side;
  result.solidTopology = axis.solid;
  if (reported)
  {
    result.axisTopology = topologyOf(axis);
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
      result.topology = analyseTopology(result.mesh);
      result.grid = gridOf(result.mesh.bounds(), options);
    });
  return result;
}

void compute(const Options& options, FieldSink* field, ProgressBar& bar, Result& result)
{
  Watch watch(bar);
  MedialAxisOptions wanted = libraryOptions(options, result.mesh.bounds().diagonal());
  wanted.field.progress = &watch;
  withFailures(options.input,
    [&]
    {
      if (options.wantsAxis())
      {
        computeAxis(wanted, !options.report.empty(), field, result);
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
  wanted.progress = &watch;
  withFailures(options.input,
    [&]
    {
      if (options.wantsThickness())
      {
        result.thickness = computeThickness(result.mesh, result.topology, wanted);
      }
      if (!options.thicknessImage.empty())
      {
        result.thicknessPicture = pictureOfThickness(surface, wanted);
      }
    });
  throwIfInterrupted();
}

} // namespace medial::app

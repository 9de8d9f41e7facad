#include "computation.h"

#include "coverage_policy.h"
#include "grid_choice.h"
#include "interrupt.h"
#include "library_calls.h"
#include "surface_thickness.h"
#include "thickness_policy.h"
#include "timer.h"

#include "medial/compute_distance_field.h"

#include <utility>

namespace medial::app
{
namespace
{

void computeField(const DistanceFieldOptions& options, FieldSink& field, Result& result)
{
  result.statistics = computeDistanceField(result.mesh, result.connectivity, result.grid,
    result.grid.wholeExtent(), field, options);
  result.sign = result.statistics.sign.method;
}

void computeAxis(const Options& options, const MedialAxisOptions& axisOptions, FieldSink* field,
  Result& result)
{
  if (field != nullptr)
  {
    result.axis =
      computeMedialAxis(result.mesh, result.connectivity, result.grid, axisOptions, *field);
  }
  else if (result.chosenResolution && result.chosenResolution->axis)
  {
    result.axis = std::move(*result.chosenResolution->axis);
    result.takenSeconds += result.axis.statistics.seconds.total();
  }
  else
  {
    result.axis = computeMedialAxis(result.mesh, result.connectivity, result.grid, axisOptions);
  }
  result.statistics = result.axis.statistics;
  result.sign = result.axis.sign;
  result.axisPoints = static_cast<std::int64_t>(result.axis.points.size());
  result.axisCells = result.axis.cellCount();
  const Timer measuring;
  if (!options.report.empty())
  {
    result.axisTopology = topologyOf(result.axis);
  }
  if (wantsCoverage(options, result.axis.side))
  {
    const MedialModel model = toMedialModel(result.axis);
    result.coverage = coverageFor(options,
      [&](std::int64_t samples, double negligible)
      {
        return measureCoverage(result.mesh, model, coverageReach(result.grid),
          { samples, negligible, axisOptions.field.execution });
      });
    if (result.coverage->uncoveredShare >= kNoticeableShare && !result.coverage->places.empty())
    {
      result.placeThickness = thicknessAt(result.coverage->places, result.mesh, result.connectivity,
        { options.threads, nullptr });
    }
  }
  result.measureSeconds = measuring.seconds();
}

void measureThickness(const Options& options, const ThicknessOptions& wanted,
  const ThicknessLimits& limits, Result& result)
{
  MeshConnectivity fineConnectivity;
  const double maxEdge = maxThicknessEdge(options, result.mesh.bounds().diagonal());
  if (maxEdge > 0.0)
  {
    result.fineMesh = subdivide(result.mesh, maxEdge, wanted.execution);
    fineConnectivity = analyseConnectivity(result.fineMesh->mesh, wanted.execution);
  }
  const MeshConnectivity& connectivity = result.fineMesh ? fineConnectivity : result.connectivity;
  result.thickness = computeThickness(result.thicknessMesh(), connectivity, wanted);
  result.thicknessTriangles = static_cast<std::int64_t>(result.thicknessMesh().triangles.size());
  if (options.hasThicknessLimits())
  {
    result.regions = findThicknessRegions(result.thicknessMesh(), *result.thickness, limits);
  }
}

} // namespace

Result prepare(const Surface& surface, const Options& options, ProgressBar& bar)
{
  Watch watch(bar);
  Result result;
  withFailures(options.input,
    [&]
    {
      result.mesh = surface.toTriangleMesh();
      result.connectivity = analyseConnectivity(result.mesh, { options.threads, &watch });
      result.meshFigures = figuresOf(result.mesh, result.connectivity);
      if (!options.resolution)
      {
        chooseResolution(options, watch, result);
        return;
      }
      result.grid = gridOf(result.mesh.bounds(), options);
    });
  return result;
}

void compute(const Options& options, FieldOutput* field, ProgressBar& bar, Result& result)
{
  if (!options.wantsAxis() && !options.localThickness.empty())
  {
    return; // the field comes with local thickness
  }
  if (field != nullptr)
  {
    field->begin(result.grid);
  }
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
  if (field != nullptr)
  {
    field->finish();
  }
}

void computeSkeleton(const Options& options, ProgressBar& bar, Result& result)
{
  if (!options.wantsSkeleton())
  {
    return;
  }
  if (result.chosenResolution && result.chosenResolution->skeleton)
  {
    result.skeleton = std::move(*result.chosenResolution->skeleton);
    result.takenSeconds += result.skeleton->seconds;
    return;
  }
  Watch watch(bar);
  SkeletonOptions wanted = skeletonOptions(options);
  wanted.execution.progress = &watch;
  withFailures(options.input,
    [&] { result.skeleton = medial::computeSkeleton(result.axis, result.mesh, wanted); });
  throwIfInterrupted();
}

void computeLocalThickness(const Options& options, FieldOutput* image, FieldOutput* field,
  ProgressBar& bar, Result& result)
{
  if (image == nullptr)
  {
    return;
  }
  FieldOutput* const fieldToo = options.wantsAxis() ? nullptr : field;
  if (fieldToo != nullptr)
  {
    fieldToo->begin(result.grid);
  }
  image->begin(result.grid);
  Watch watch(bar);
  LocalThicknessOptions wanted = localThicknessOptions(options);
  wanted.field.execution.progress = &watch;
  withFailures(options.input,
    [&]
    {
      result.localThickness = computeLocalThickness(result.mesh, result.connectivity, result.grid,
        *image, wanted, fieldToo);
    });
  if (!options.wantsAxis())
  {
    result.statistics = result.localThickness->field;
    result.sign = result.statistics.sign.method;
  }
  throwIfInterrupted();
  if (fieldToo != nullptr)
  {
    fieldToo->finish();
  }
  image->finish();
}

void computeThickness(const Options& options, Surface& surface, ProgressBar& bar, Result& result)
{
  if (!options.wantsThickness())
  {
    return;
  }
  Watch watch(bar);
  ThicknessOptions wanted = thicknessOptions(options);
  wanted.execution.progress = &watch;
  const double diagonal = result.mesh.bounds().diagonal();
  const ThicknessLimits limits = thicknessLimits(options, diagonal);
  if (options.hasThicknessLimits())
  {
    requireLimits(limits);
  }
  withFailures(options.input,
    [&]
    {
      if (options.hasThicknessLimits() && options.side != Side::Both)
      {
        requireInside(result.mesh, result.connectivity, wanted.execution);
      }
      measureThickness(options, wanted, limits, result);
      if (!options.thickness.empty() || !options.thicknessImage.empty())
      {
        result.thicknessSurface = withThickness(surface.polyData(), result);
      }
      if (!options.thicknessImage.empty())
      {
        result.thicknessPicture = result.fineMesh ? result.thicknessSurface
                                                  : pictureOfThickness(surface.polyData(), wanted);
      }
    });
  throwIfInterrupted();
}

} // namespace medial::app

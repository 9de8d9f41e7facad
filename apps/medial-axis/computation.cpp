#include "computation.h"

#include "interrupt.h"
#include "library_calls.h"
#include "surface_thickness.h"
#include "timer.h"

#include "medial/compute_distance_field.h"

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
  result.sign = result.statistics.sign.method;
}

double voxelDiagonal(const Grid& grid)
{
  return std::hypot(grid.spacing[0], grid.spacing[1], grid.spacing[2]);
}

/// Measures what a report states. Only for the note in the summary, a bound on fewer samples is
/// enough unless the share may be noticeable.
AxisCoverage coverageOf(const Result& result, const Options& options,
  const DistanceFieldOptions& fieldOptions)
{
  const MedialModel model = toMedialModel(result.axis);
  const auto measure = [&](std::int64_t samples, double negligible)
  {
    CoverageOptions coverageOptions;
    coverageOptions.execution = fieldOptions.execution;
    coverageOptions.samples = samples;
    coverageOptions.negligible = negligible;
    return measureCoverage(result.mesh, model, voxelDiagonal(result.grid), coverageOptions);
  };
  if (options.report.empty())
  {
    constexpr std::int64_t kFewSamples = 4000;
    const AxisCoverage bound = measure(kFewSamples, 0.5 * kNoticeableShare);
    if (bound.uncoveredShare < 0.5 * kNoticeableShare)
    {
      return bound;
    }
  }
  return measure(kDefaultCoverageSamples, 0.0);
}

void computeAxis(const Options& options, const MedialAxisOptions& axisOptions, FieldSink* field,
  Result& result)
{
  result.axis = field != nullptr
    ? computeMedialAxis(result.mesh, result.connectivity, result.grid, axisOptions, *field)
    : computeMedialAxis(result.mesh, result.connectivity, result.grid, axisOptions);
  result.statistics = result.axis.statistics;
  result.sign = result.axis.sign;
  const Timer measuring;
  if (!options.report.empty())
  {
    result.axisTopology = topologyOf(result.axis);
  }
  if (result.axis.side == Side::Interior && (!options.report.empty() || !options.quiet))
  {
    result.coverage = coverageOf(result, options, axisOptions.field);
  }
  result.measureSeconds = measuring.seconds();
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
      result.grid = gridOf(result.mesh.bounds(), options);
    });
  return result;
}

void compute(const Options& options, FieldOutput* field, ProgressBar& bar, Result& result)
{
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

void computeLocalThickness(const Options& options, FieldOutput* image, ProgressBar& bar,
  Result& result)
{
  if (image == nullptr)
  {
    return;
  }
  image->begin(result.grid);
  Watch watch(bar);
  LocalThicknessOptions wanted = localThicknessOptions(options);
  wanted.field.execution.progress = &watch;
  withFailures(options.input,
    [&]
    {
      result.localThickness =
        computeLocalThickness(result.mesh, result.connectivity, result.grid, *image, wanted);
    });
  if (!options.wantsAxis() && options.field.empty())
  {
    result.statistics = result.localThickness->field;
    result.sign = result.statistics.sign.method;
  }
  throwIfInterrupted();
  image->finish();
}

void computeThickness(const Options& options, Surface& surface, ProgressBar& bar, Result& result)
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
        result.thicknessPicture = pictureOfThickness(surface.polyData(), wanted);
      }
    });
  throwIfInterrupted();
}

} // namespace medial::app

#include "computation.h"

#include "failure.h"
#include "interrupt.h"
#include "library_calls.h"
#include "surface_thickness.h"
#include "timer.h"

#include "medial/compute_distance_field.h"
#include "medial/error.h"
#include "medial/point_distance.h"

#include <algorithm>
#include <cmath>
#include <string>
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

double sumOf(const RunStatistics::Seconds& seconds)
{
  return seconds.sites + seconds.sign + seconds.cull + seconds.polygons + seconds.draw +
    seconds.resolve + seconds.medial;
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
    result.takenSeconds += sumOf(result.axis.statistics.seconds);
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

void chooseResolution(const Options& options, Watch& watch, Result& result)
{
  const Bounds bounds = result.mesh.bounds();
  MedialAxisOptions ofAxis = libraryOptions(options, bounds.diagonal());
  ofAxis.field.execution.progress = &watch;
  SkeletonOptions ofSkeleton = skeletonOptions(options);
  ofSkeleton.execution.progress = &watch;
  result.chosenResolution =
    chooseSkeletonResolution(result.mesh, result.connectivity, ofAxis, ofSkeleton, options.padding);
  result.grid = makeGrid(bounds, result.chosenResolution->resolution, options.padding);
}

} // namespace

double maxThicknessEdge(const Options& options, double diagonal)
{
  // Limits are to be kept inside large faces as well.
  constexpr Length kMaxEdge{ 2.0, true };
  const Length maxEdge =
    options.maxEdge.value_or(options.hasThicknessLimits() ? kMaxEdge : Length{});
  return maxEdge.value > 0.0 ? maxEdge.inUnits(diagonal) : 0.0;
}

void requireLimits(const ThicknessLimits& limits)
{
  try
  {
    checkThicknessLimits(limits);
  }
  catch (const Error& error)
  {
    throw Failure(ExitCode::Usage,
      std::string("--min-thickness, --max-thickness: ") + error.what());
  }
}

MeshFigures figuresOf(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
{
  return { mesh.triangles.size(), mesh.points.size(), connectivity.components,
    mesh.degenerateTriangles, connectivity.closed(), connectivity.manifold(),
    mesh.bounds().diagonal() };
}

AxisCoverage coverageFor(const Options& options,
  const std::function<AxisCoverage(std::int64_t samples, double negligible)>& measure)
{
  if (!options.wantsWholeCoverage())
  {
    constexpr std::int64_t kFewSamples = 4000;
    AxisCoverage bound = measure(kFewSamples, 0.5 * kNoticeableShare);
    if (bound.uncoveredShare < 0.5 * kNoticeableShare)
    {
      return bound;
    }
  }
  return measure(kDefaultCoverageSamples, 0.0);
}

bool wantsCoverage(const Options& options, Side side)
{
  return side == Side::Interior &&
    (options.wantsWholeCoverage() || (!options.quiet && options.showsAxis()));
}

double coverageReach(const Grid& grid)
{
  return std::hypot(grid.spacing[0], grid.spacing[1], grid.spacing[2]);
}

std::vector<double> thicknessAt(const std::vector<UncoveredPlace>& places, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Execution& execution)
{
  ThicknessOptions options;
  options.method = ThicknessMethod::Ray;
  options.cells = true;
  options.execution = execution;
  const Thickness thickness = computeThickness(mesh, connectivity, options);
  std::vector<Point3> points;
  for (const UncoveredPlace& place : places)
  {
    points.push_back(place.point);
  }
  const PointDistance nearest(mesh, SignMethod::None, execution);
  const std::vector<std::int64_t> cells = nearest.compute(points, execution).closestCell;
  std::vector<double> values(places.size(), std::nan(""));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (std::size_t place = 0; place < places.size(); ++place)
    {
      if (mesh.triangleCells[i] == cells[place])
      {
        values[place] = std::fmin(values[place], static_cast<double>(thickness.triangleValues[i]));
      }
    }
  }
  return values;
}

Grid gridOf(const Bounds& bounds, const Options& options)
{
  if (options.spacing)
  {
    const double spacing = *options.spacing;
    return makeGridWithSpacing(bounds, { spacing, spacing, spacing }, options.padding);
  }
  return makeGrid(bounds, options.resolution.value_or(kDefaultResolution), options.padding);
}

std::optional<double> Result::catchingSpacing(const Options& options) const
{
  const double diagonal = meshFigures.diagonal;
  const double minRadius =
    std::max(options.lambda.inUnits(diagonal), options.minRadius.inUnits(diagonal));
  // Four grid points, the corners of a square, lie inside a rod of 2 sqrt(2) times their spacing.
  constexpr double kSpacings = 3.0;
  std::optional<double> spacing;
  for (const double wall : placeThickness)
  {
    const double wanted = wall / kSpacings;
    if (0.5 * wall > minRadius && options.maxSpheres == 0 &&
      wanted < std::max({ grid.spacing[0], grid.spacing[1], grid.spacing[2] }))
    {
      spacing = std::min(wanted, spacing.value_or(wanted));
    }
  }
  return spacing;
}

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

#include "coverage_policy.h"

#include "medial/point_distance.h"
#include "medial/thickness.h"

#include <algorithm>
#include <cmath>

namespace medial::app
{

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
  return side == Side::Interior && (options.wantsWholeCoverage() || !options.quiet);
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

std::optional<double> catchingSpacing(const Result& result, const Options& options)
{
  const double diagonal = result.meshFigures.diagonal;
  const double minRadius =
    std::max(options.lambda.inUnits(diagonal), options.minRadius.inUnits(diagonal));
  // Four grid points, the corners of a square, lie inside a rod of 2 sqrt(2) times their spacing.
  constexpr double kSpacings = 3.0;
  std::optional<double> spacing;
  for (const double wall : result.placeThickness)
  {
    const double wanted = wall / kSpacings;
    if (0.5 * wall > minRadius && options.maxSpheres == 0 &&
      wanted < std::max({ result.grid.spacing[0], result.grid.spacing[1], result.grid.spacing[2] }))
    {
      spacing = std::min(wanted, spacing.value_or(wanted));
    }
  }
  return spacing;
}

} // namespace medial::app

#include "medial/axis_coverage.h"

#include "medial/error.h"

#include "balls/ball_union.h"
#include "base/stopwatch.h"
#include "measure/sample_values.h"
#include "measure/surface_samples.h"
#include "measure/uncovered_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace medial
{
namespace
{

constexpr const char* kPhase = "coverage";

using Samples = std::vector<glm::dvec3>;

/// Every so many balls are tried one after the other: few of them cover most of a surface, and
/// their tree is built fast.
constexpr std::array<std::size_t, 3> kSteps{ 16, 4, 1 };

/// Returns the balls of a model from the first one on, `step` apart.
MedialModel ballsOf(const MedialModel& model, std::size_t step)
{
  MedialModel balls;
  for (std::size_t i = 0; i < model.centres.size(); i += step)
  {
    balls.centres.push_back(model.centres[i]);
    balls.radii.push_back(model.radii[i]);
  }
  return balls;
}

/// Returns the samples that are not within reach of a union.
Samples uncovered(const Samples& samples, const BallUnion& solid, double reach, const Run& run)
{
  const std::vector<double> bare = sampleValues(run.part(0.2, 1.0), samples.size(), kPhase,
    [&](std::size_t i) { return solid.covers(samples[i], -reach) ? 0.0 : 1.0; });
  Samples left;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (bare[i] > 0.0)
    {
      left.push_back(samples[i]);
    }
  }
  return left;
}

/// Balls a voxel apart cover nearly everything, and there are half as many of them as wedges. So
/// some balls come first, then all of them, then wedges, as long as more than a negligible part is
/// left.
/// Returns the samples that are left.
Samples uncoveredBy(const Samples& samples, const MedialModel& model, double reach,
  double negligible, const Run& run)
{
  const double count = std::max<double>(1.0, static_cast<double>(samples.size()));
  Samples left = samples;
  const auto stillMatters = [&]
  {
    return !model.centres.empty() && !left.empty() &&
      static_cast<double>(left.size()) >= negligible * count;
  };
  run.report(0.0, kPhase);
  double done = 0.0;
  for (const std::size_t step : kSteps)
  {
    if (stillMatters())
    {
      left =
        uncovered(left, BallUnion(ballsOf(model, step), false), reach, run.part(done, done + 0.2));
    }
    done += 0.2;
  }
  if (stillMatters())
  {
    left = uncovered(left, BallUnion(model, true), reach, run.part(done, 1.0));
  }
  run.report(1.0, kPhase);
  return left;
}

} // namespace

AxisCoverage measureCoverage(const TriangleMesh& mesh, const MedialModel& model, double reach,
  const CoverageOptions& options)
{
  checkSampleCount(options.samples);
  const Run run(options.execution);
  if (!(reach >= 0.0) || !std::isfinite(reach))
  {
    throw Error(ErrorCode::InvalidInput,
      "reach " + std::to_string(reach) + " is outside [0, infinity)");
  }
  if (!(options.negligible >= 0.0 && options.negligible <= 1.0))
  {
    throw Error(ErrorCode::InvalidInput,
      "negligible share " + std::to_string(options.negligible) + " is outside [0, 1]");
  }
  AxisCoverage coverage;
  coverage.reach = reach;
  timed(coverage.seconds,
    [&]
    {
      Samples samples;
      if (surfaceArea(mesh) > 0.0)
      {
        samples = surfaceSamples(mesh, options.samples);
      }
      coverage.samples = static_cast<std::int64_t>(samples.size());
      const Samples left =
        run.onThreads([&] { return uncoveredBy(samples, model, reach, options.negligible, run); });
      const double count = std::max<double>(1.0, static_cast<double>(samples.size()));
      coverage.uncoveredShare = static_cast<double>(left.size()) / count;
      const bool bound = static_cast<double>(left.size()) < options.negligible * count;
      if (!bound && !left.empty())
      {
        coverage.places = uncoveredPlaces(left, 2.0 * std::sqrt(surfaceArea(mesh) / count), count);
      }
    });
  return coverage;
}

} // namespace medial

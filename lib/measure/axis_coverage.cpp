#include "measure/coverage.h"

#include "base/range_check.h"
#include "medial/error.h"

#include "balls/ball_union.h"
#include "base/stopwatch.h"
#include "measure/nearby_model.h"
#include "measure/sample_values.h"
#include "measure/surface_samples.h"
#include "measure/uncovered_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace medial
{
namespace
{

/// Every so many balls are tried one after the other: few of them cover most of a surface, and
/// their tree is built fast.
constexpr std::array<std::size_t, 3> kSteps{ 16, 4, 1 };

} // namespace

void checkCoverage(double reach, const CoverageOptions& options)
{
  checkSampleCount(options.samples);
  if (!(reach >= 0.0) || !std::isfinite(reach))
  {
    throwOutside("reach", reach, "[0, infinity)");
  }
  if (!(options.negligible >= 0.0 && options.negligible <= 1.0))
  {
    throwOutside("negligible share", options.negligible, closedRange(0.0, 1.0));
  }
}

MedialModel ballsOf(const MedialModel& model, std::size_t step,
  const std::function<std::int64_t(std::size_t)>& numberOf)
{
  MedialModel balls;
  for (std::size_t i = 0; i < model.centres.size(); ++i)
  {
    if (numberOf(i) % static_cast<std::int64_t>(step) == 0)
    {
      balls.centres.push_back(model.centres[i]);
      balls.radii.push_back(model.radii[i]);
    }
  }
  return balls;
}

std::vector<char> coveredBy(const MedialModel& model, bool interpolate,
  const std::vector<glm::dvec3>& samples, double reach, const Run& run)
{
  // A tree over the few places that are left is built much faster than one over the model.
  constexpr std::size_t kManyBalls = 8; // for each sample
  const bool isLarge = model.centres.size() > kManyBalls * samples.size();
  const MedialModel near = isLarge ? modelNear(model, interpolate, samples, reach) : MedialModel();
  const MedialModel& searched = isLarge ? near : model;
  if (searched.centres.empty())
  {
    return std::vector<char>(samples.size(), 0);
  }
  const BallUnion solid(searched, interpolate);
  const std::vector<double> covered = sampleValues(run.part(0.2, 1.0), samples.size(),
    kCoveragePhase, [&](std::size_t i) { return solid.covers(samples[i], -reach) ? 1.0 : 0.0; });
  return { covered.begin(), covered.end() };
}

/// Balls a voxel apart cover nearly everything, and there are half as many of them as wedges. So
/// some balls come first, then all of them, then wedges, as long as more than a negligible part is
/// left.
AxisCoverage coverageOf(const std::vector<glm::dvec3>& samples, double area, double reach,
  double negligible, const Run& run, const Covering& covering)
{
  AxisCoverage coverage;
  coverage.reach = reach;
  coverage.samples = static_cast<std::int64_t>(samples.size());
  const double count = std::max<double>(1.0, static_cast<double>(samples.size()));
  std::vector<glm::dvec3> left = samples;
  const auto leave = [&](std::size_t step, bool interpolate, const Run& part)
  {
    if (left.empty() || static_cast<double>(left.size()) < negligible * count)
    {
      return;
    }
    const std::vector<char> covered = covering(left, step, interpolate, part);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < left.size(); ++i)
    {
      left[kept] = left[i];
      kept += covered[i] == 0 ? 1 : 0;
    }
    left.resize(kept);
  };
  run.report(0.0, kCoveragePhase);
  double done = 0.0;
  for (const std::size_t step : kSteps)
  {
    leave(step, false, run.part(done, done + 0.2));
    done += 0.2;
  }
  leave(1, true, run.part(done, 1.0));
  run.report(1.0, kCoveragePhase);
  coverage.uncoveredShare = static_cast<double>(left.size()) / count;
  const bool bound = static_cast<double>(left.size()) < negligible * count;
  if (!bound && !left.empty())
  {
    coverage.places = uncoveredPlaces(left, 2.0 * std::sqrt(area / count), count);
  }
  return coverage;
}

AxisCoverage measureCoverage(const TriangleMesh& mesh, const MedialModel& model, double reach,
  const CoverageOptions& options)
{
  checkCoverage(reach, options);
  const Run run(options.execution);
  AxisCoverage coverage;
  double seconds = 0.0;
  timed(seconds,
    [&]
    {
      const double area = surfaceArea(mesh);
      std::vector<glm::dvec3> samples;
      if (area > 0.0)
      {
        samples = surfaceSamples(mesh, options.samples);
      }
      const Covering covering = [&](const std::vector<glm::dvec3>& left, std::size_t step,
                                  bool interpolate, const Run& part)
      {
        const auto numberOf = [](std::size_t i) { return static_cast<std::int64_t>(i); };
        return coveredBy(interpolate ? model : ballsOf(model, step, numberOf), interpolate, left,
          reach, part);
      };
      coverage = run.onThreads(
        [&] { return coverageOf(samples, area, reach, options.negligible, run, covering); });
    });
  coverage.seconds = seconds;
  return coverage;
}

} // namespace medial

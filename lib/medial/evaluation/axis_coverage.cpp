#include "medial/medial/evaluation/axis_coverage.h"

#include "medial/common/stopwatch.h"
#include "medial/medial/evaluation/ball_union.h"
#include "medial/medial/evaluation/evaluation_steps.h"
#include "medial/medial/evaluation/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace medial
{
namespace
{

using Samples = std::vector<glm::dvec3>;

/// The samples that are not within reach of the balls, or of cones and slabs as well.
Samples uncovered(const Samples& samples, const MedialModel& model, bool interpolate, double reach,
  Steps& steps)
{
  if (model.centres.empty() || samples.empty())
  {
    return samples;
  }
  steps.report(interpolate ? 0.5 : 0.0, "coverage");
  const BallUnion solid(model, interpolate);
  const std::vector<double> bare =
    steps.evaluate(samples.size(), interpolate ? 0.6 : 0.1, interpolate ? 1.0 : 0.5, "coverage",
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

double uncoveredShare(const Samples& samples, const MedialModel& model, double reach,
  Progress* progress)
{
  Steps steps(progress);
  // Balls a voxel apart cover nearly everything, and there are half as many as slabs.
  const Samples besideBalls = uncovered(samples, model, false, reach, steps);
  const Samples left = uncovered(besideBalls, model, true, reach, steps);
  steps.report(1.0, "coverage");
  return static_cast<double>(left.size()) /
    std::max<double>(1.0, static_cast<double>(samples.size()));
}

} // namespace

AxisCoverage measureCoverage(const TriangleMesh& mesh, const MedialModel& model, double reach,
  const EvaluationOptions& options)
{
  checkEvaluation(options);
  if (!(reach >= 0.0) || !std::isfinite(reach))
  {
    throw Error(ErrorCode::InvalidInput,
      "reach " + std::to_string(reach) + " is outside [0, infinity)");
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
      coverage.uncoveredShare = onThreads(options.threads,
        [&] { return uncoveredShare(samples, model, reach, options.progress); });
    });
  return coverage;
}

} // namespace medial

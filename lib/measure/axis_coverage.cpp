#include "medial/axis_coverage.h"

#include "medial/error.h"

#include "balls/ball_union.h"
#include "base/stopwatch.h"
#include "measure/sample_values.h"
#include "measure/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace medial
{
namespace
{

constexpr const char* kPhase = "coverage";

using Samples = std::vector<glm::dvec3>;

/// Returns the samples that are not within reach of the balls, or of cones and wedges as well.
Samples uncovered(const Samples& samples, const MedialModel& model, bool interpolate, double reach,
  const Run& run)
{
  if (model.centres.empty() || samples.empty())
  {
    return samples;
  }
  run.report(0.0, kPhase);
  const BallUnion solid(model, interpolate);
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

double uncoveredShare(const Samples& samples, const MedialModel& model, double reach,
  const Run& run)
{
  // Balls a voxel apart cover nearly everything, and there are half as many of them as wedges.
  const Samples besideBalls = uncovered(samples, model, false, reach, run.part(0.0, 0.5));
  const Samples left = uncovered(besideBalls, model, true, reach, run.part(0.5, 1.0));
  run.report(1.0, kPhase);
  return static_cast<double>(left.size()) /
    std::max<double>(1.0, static_cast<double>(samples.size()));
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
      coverage.uncoveredShare =
        run.onThreads([&] { return uncoveredShare(samples, model, reach, run); });
    });
  return coverage;
}

} // namespace medial

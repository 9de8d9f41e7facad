#include "medial/medial/evaluation/axis_coverage.h"

#include "medial/common/stopwatch.h"
#include "medial/medial/evaluation/ball_union.h"
#include "medial/medial/evaluation/evaluation_steps.h"
#include "medial/medial/evaluation/surface_samples.h"

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace medial
{
namespace
{

double uncoveredShare(const std::vector<glm::dvec3>& samples, const MedialModel& model,
  double reach, Progress* progress)
{
  if (model.centres.empty())
  {
    return samples.empty() ? 0.0 : 1.0;
  }
  Steps steps(progress);
  steps.report(0.0, "coverage");
  const BallUnion solid(model);
  const std::vector<double> uncovered = steps.evaluate(samples.size(), 0.3, 1.0, "coverage",
    [&](std::size_t i) { return solid.covers(samples[i], -reach) ? 0.0 : 1.0; });
  steps.report(1.0, "coverage");
  return std::accumulate(uncovered.begin(), uncovered.end(), 0.0) /
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
      std::vector<glm::dvec3> samples;
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

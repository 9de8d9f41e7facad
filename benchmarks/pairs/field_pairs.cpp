#include "pairs/field_pairs.h"

#include "medial/field_proximity.h"
#include "methods/field_method.h"
#include "pairs/pair_race.h"
#include "statistics.h"

#include "base/stopwatch.h"

#include <memory>
#include <string>
#include <vector>

namespace medial::benchmark
{
namespace
{

/// Frames in which the baseline is measured, which takes hundreds of times as long.
constexpr int kBaselineFrames = 3;

/// The paper's way: FieldProximitySolver.
class FieldPairs final : public PairMethod
{
public:
  explicit FieldPairs(int resolution) { options_.resolution = resolution; }

  std::string name() const override
  {
    return "fields of " + std::to_string(options_.resolution) + " points";
  }

  void start(const TriangleMesh& a, const TriangleMesh& b) override
  {
    solver_ = std::make_unique<FieldProximitySolver>(a, b);
  }

  void update(const std::vector<Point3>& a, const std::vector<Point3>& b) override
  {
    solver_->setPoints(0, a);
    solver_->setPoints(1, b);
  }

  PairAnswer answer() override
  {
    const FieldProximity found = solver_->compute(options_);
    PairAnswer answer;
    answer.collide = found.collide;
    answer.separation = found.separation;
    answer.depth = found.depth;
    return answer;
  }

private:
  FieldProximityOptions options_;
  std::unique_ptr<FieldProximitySolver> solver_;
};

/// Seconds that a method takes for the fields of both meshes of a frame.
double baselineSeconds(FieldMethod& method, const MovingPair& pair, std::size_t frame,
  int resolution)
{
  TriangleMesh a = pair.a;
  TriangleMesh b = pair.b;
  a.points = pair.pointsA[frame];
  b.points = pair.pointsB[frame];
  FieldProximityOptions options;
  options.resolution = resolution;
  const Grid grid = FieldProximitySolver(a, b).compute(options).grid;
  double seconds = 0.0;
  for (const TriangleMesh* mesh : { &a, &b })
  {
    timed(seconds, [&] { return method.compute(*mesh, grid); });
  }
  return seconds;
}

/// Median of the baseline's seconds in some frames over those of a run.
double baselineRatio(const MovingPair& pair, const std::vector<double>& seconds, int resolution,
  double& baseline)
{
  const std::unique_ptr<FieldMethod> havoc = makeHavocMethod();
  std::vector<double> all;
  std::vector<double> ratios;
  for (int i = 1; i <= kBaselineFrames; ++i)
  {
    const std::size_t frame = seconds.size() * i / kBaselineFrames - 1;
    all.push_back(baselineSeconds(*havoc, pair, frame, resolution));
    ratios.push_back(all.back() / seconds[frame]);
  }
  baseline = median(all);
  return median(ratios);
}

std::string milliseconds(double seconds)
{
  return number(1e3 * seconds);
}

} // namespace

Table raceFields(const MovingPair& pair, int rounds, bool quick)
{
  const std::vector<int> resolutions = quick ? std::vector<int>{ 8 } : std::vector{ 64, 128, 256 };
  std::vector<PairMethodEntry> entries = { { kMedialAllId, {},
    [] { return makeMedialPairs(PairQuestion::Contacts); } } };
  for (const int resolution : resolutions)
  {
    entries.push_back({ "fields-" + std::to_string(resolution), {},
      [resolution] { return std::make_unique<FieldPairs>(resolution); } });
  }
  const std::vector<PairRun> runs = racePairs(pair, entries, rounds);
  Table table;
  table.title = "The paper's way, distance fields of both meshes where they come close "
                "(FieldProximitySolver), for " +
    pair.name + ". HAVOC-style is the baseline's time for the same fields, median of " +
    std::to_string(kBaselineFrames) + " frames. Times in ms.";
  table.columns = { "grid points along the longest side", "apart", "colliding", "frame",
    "HAVOC-style", "HAVOC-style over fields", "wrong collisions", "depth over the exact one" };
  for (std::size_t i = 0; i < resolutions.size(); ++i)
  {
    const PairRun& run = runs[i + 1];
    const std::vector<double> seconds = run.frameSeconds();
    const PairDifference difference = compareAnswers(run, runs.front());
    double baseline = 0.0;
    const double ratio = baselineRatio(pair, seconds, resolutions[i], baseline);
    table.rows.push_back(
      { std::to_string(resolutions[i]), milliseconds(medianWhere(seconds, runs.front(), false)),
        milliseconds(medianWhere(seconds, runs.front(), true)), milliseconds(median(seconds)),
        milliseconds(baseline), number(ratio), std::to_string(difference.wrongCollisions),
        number(difference.depthRatio, 2) });
  }
  return table;
}

} // namespace medial::benchmark

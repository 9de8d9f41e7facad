#include "pairs/pair_race.h"

#include "statistics.h"

#include "base/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace medial::benchmark
{
namespace
{

constexpr int kUncountedFrames = 3;

/// One frame by one method.
void takeTurn(PairMethod& method, const MovingPair& pair, std::size_t frame, PairRun& run)
{
  double update = 0.0;
  double query = 0.0;
  timed(update, [&] { method.update(pair.pointsA[frame], pair.pointsB[frame]); });
  const PairAnswer answer = timed(query, [&] { return method.answer(); });
  run.update.back().push_back(update);
  run.query.back().push_back(query);
  if (run.answers.size() <= frame)
  {
    run.answers.push_back(answer);
  }
}

void warmUp(PairMethod& method, const MovingPair& pair)
{
  method.start(pair.a, pair.b);
  const int frames = static_cast<int>(pair.pointsA.size());
  for (int i = 0; i < kUncountedFrames; ++i)
  {
    const auto frame = static_cast<std::size_t>(frames * (i + 1) / kUncountedFrames - 1);
    method.update(pair.pointsA[frame], pair.pointsB[frame]);
    method.answer();
  }
}

} // namespace

std::vector<double> PairRun::frameSeconds() const
{
  std::vector<double> result;
  for (std::size_t frame = 0; frame < answers.size(); ++frame)
  {
    std::vector<double> rounds;
    for (std::size_t round = 0; round < update.size(); ++round)
    {
      rounds.push_back(update[round][frame] + query[round][frame]);
    }
    result.push_back(median(rounds));
  }
  return result;
}

std::vector<PairRun> racePairs(const MovingPair& pair, const std::vector<PairMethodEntry>& entries,
  int rounds)
{
  std::vector<PairRun> runs;
  std::vector<std::unique_ptr<PairMethod>> methods;
  for (const PairMethodEntry& entry : entries)
  {
    methods.push_back(entry.make());
    warmUp(*methods.back(), pair);
    runs.emplace_back();
    runs.back().id = entry.id;
    runs.back().name = methods.back()->name();
    runs.back().questions = entry.questions;
  }
  std::vector<std::size_t> turns(methods.size());
  std::iota(turns.begin(), turns.end(), std::size_t{ 0 });
  std::mt19937 random(1);
  for (int round = 0; round < rounds; ++round)
  {
    for (PairRun& run : runs)
    {
      run.update.emplace_back();
      run.query.emplace_back();
    }
    for (std::size_t frame = 0; frame < pair.pointsA.size(); ++frame)
    {
      // What a method finds in caches depends on the one before it.
      std::shuffle(turns.begin(), turns.end(), random);
      for (const std::size_t i : turns)
      {
        takeTurn(*methods[i], pair, frame, runs[i]);
      }
    }
  }
  return runs;
}

double medianWhere(const std::vector<double>& seconds, const PairRun& truth, bool colliding)
{
  std::vector<double> chosen;
  for (std::size_t frame = 0; frame < seconds.size(); ++frame)
  {
    if (*truth.answers[frame].collide == colliding)
    {
      chosen.push_back(seconds[frame]);
    }
  }
  return median(chosen);
}

PairDifference compareAnswers(const PairRun& run, const PairRun& truth)
{
  PairDifference difference;
  std::vector<double> depthRatios;
  for (std::size_t frame = 0; frame < run.answers.size(); ++frame)
  {
    const PairAnswer& answer = run.answers[frame];
    const PairAnswer& right = truth.answers[frame];
    if (answer.collide)
    {
      difference.hasCollisions = true;
      difference.wrongCollisions += *answer.collide != *right.collide ? 1 : 0;
    }
    if (answer.separation)
    {
      difference.hasSeparation = true;
      difference.separation =
        std::max(difference.separation, std::abs(*answer.separation - *right.separation));
    }
    if (answer.pointDepth)
    {
      difference.hasPointDepth = true;
      difference.pointDepth =
        std::max(difference.pointDepth, std::abs(*answer.pointDepth - *right.pointDepth));
    }
    if (answer.depth && *right.depth > 0.0)
    {
      depthRatios.push_back(*answer.depth / *right.depth);
    }
  }
  difference.depthRatio = median(depthRatios);
  return difference;
}

} // namespace medial::benchmark

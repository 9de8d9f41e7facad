#pragma once

#include "medial/common/error.h"
#include "medial/common/progress.h"
#include "medial/medial/evaluation/axis_evaluation.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace medial
{

/// @throws Error InvalidInput for a number of samples or threads outside its range.
void checkEvaluation(const EvaluationOptions& options);

/// Tells how far the work is, and ends it when it is to be cancelled.
class Steps
{
public:
  explicit Steps(Progress* progress)
    : progress_(progress)
  {
  }

  void report(double fraction, const char* phase)
  {
    if (progress_ == nullptr)
    {
      return;
    }
    progress_->report(fraction, phase);
    if (progress_->cancelled())
    {
      throw Error(ErrorCode::Cancelled, "cancelled");
    }
  }

  /// Evaluates `value(i)` for i in [0, count) on all threads.
  template <typename Value>
  std::vector<double> evaluate(std::size_t count, double from, double to, const char* phase,
    const Value& value)
  {
    constexpr std::size_t kBatch = 16384;
    std::vector<double> values(count);
    for (std::size_t first = 0; first < count; first += kBatch)
    {
      this->report(from + (to - from) * static_cast<double>(first) / static_cast<double>(count),
        phase);
      tbb::parallel_for(first, std::min(count, first + kBatch),
        [&](std::size_t i) { values[i] = value(i); });
    }
    return values;
  }

private:
  Progress* progress_;
};

/// Runs `work` with that many threads at most; 0 for all cores.
template <typename Work>
auto onThreads(int threads, const Work& work)
{
  const int cores = tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(threads > 0 ? std::min(threads, cores) : cores);
  return arena.execute(work);
}

} // namespace medial

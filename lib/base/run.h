#pragma once

#include "medial/execution.h"

#include <tbb/task_arena.h>

namespace medial
{

/// An operation under way, or a part of one: the threads it may use and its share of the progress.
class Run
{
public:
  /// @throws Error InvalidInput for a negative number of threads.
  explicit Run(const Execution& execution);

  /// A part of this operation, whose progress from 0 to 1 fills [begin, end] of it.
  Run part(double begin, double end) const;

  /// Reports progress.
  /// @throws Error Cancelled where the caller wants to stop.
  void report(double fraction, const char* phase) const;

  /// At least 1.
  int threads() const { return threads_; }

  /// Runs `work`, whose parallel loops then use no more threads than these.
  template <typename Work>
  auto onThreads(const Work& work) const
  {
    tbb::task_arena arena(threads_);
    return arena.execute(work);
  }

private:
  Progress* progress_;
  int threads_;
  double begin_ = 0.0;
  double end_ = 1.0;
};

} // namespace medial

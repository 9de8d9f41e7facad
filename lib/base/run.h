#pragma once

#include "base/borrowed_arena.h"
#include "medial/execution.h"

namespace medial
{

/// A running operation or a part of one: the threads it may use and its share of the progress.
class Run
{
public:
  /// @throws Error InvalidInput for a negative number of threads.
  explicit Run(const Execution& execution);

  /// Returns a part of this operation. Its progress from 0 to 1 fills [begin, end] of the whole.
  Run part(double begin, double end) const;

  /// Reports progress.
  /// @param fraction of this part, in [0, 1].
  /// @param phase as for Progress::report().
  /// @throws Error Cancelled if the caller wants to stop.
  void report(double fraction, const char* phase) const;

  /// Number of threads, at least 1.
  int threads() const { return threads_; }

  /// Runs `work` with parallel loops limited to these threads.
  template <typename Work>
  auto onThreads(const Work& work) const
  {
    const BorrowedArena arena(threads_);
    return arena->execute(work);
  }

private:
  Progress* progress_;
  int threads_;
  double begin_ = 0.0;
  double end_ = 1.0;
};

} // namespace medial

#pragma once

#include "base/run.h"

#include <chrono>
#include <cstddef>
#include <thread>

namespace medial
{

/// Reports progress and checks for cancelling within a step whose length is unknown.
class Checkpoint
{
public:
  /// @param fraction progress to report during the step, in [0, 1]; see Run::report().
  /// @param phase what is being done; see Run::report().
  Checkpoint(const Run& run, double fraction, const char* phase);

  /// Reports progress at most every 20 ms, and only on the thread that made this object. Loops may
  /// therefore call it for every part, however small, on any thread.
  /// @throws Error Cancelled if the caller wants to stop.
  void operator()() const;
  /// The same for loops whose parts take less time than asking: asks at one part of 1,024.
  void operator()(std::size_t part) const
  {
    if (part % 1024 == 0)
    {
      (*this)();
    }
  }

private:
  using Clock = std::chrono::steady_clock;

  Run run_;
  double fraction_;
  const char* phase_;
  std::thread::id thread_;
  mutable Clock::time_point last_;
};

} // namespace medial

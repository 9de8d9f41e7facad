#pragma once

#include "base/run.h"

#include <chrono>
#include <thread>

namespace medial
{

/// Lets work be cancelled within a step whose share of the whole is not known.
class Checkpoint
{
public:
  /// @param fraction, phase what is reported, see Run::report().
  Checkpoint(const Run& run, double fraction, const char* phase);

  /// Reports, every 20 ms at most and only in the thread that made this object: loops over parts of
  /// any size, in any thread, may call it for each part.
  /// @throws Error Cancelled where the caller wants to stop.
  void operator()() const;

private:
  using Clock = std::chrono::steady_clock;

  Run run_;
  double fraction_;
  const char* phase_;
  std::thread::id thread_;
  mutable Clock::time_point last_;
};

} // namespace medial

#pragma once

#include <chrono>
#include <thread>

namespace medial
{

class Progress;

/// Lets work be cancelled amid a step whose share of the whole is not known.
class Checkpoint
{
public:
  /// @param progress may be null: nothing happens then. It must outlive this object.
  /// @param fraction, phase what is reported, see Progress::report().
  Checkpoint(Progress* progress, double fraction, const char* phase);

  /// Reports, and throws Error Cancelled where that is wanted. Does so every 20 ms at most and in
  /// the thread that made this object only, so that loops over parts of any size, in any thread,
  /// may call it for each.
  void operator()() const;

private:
  using Clock = std::chrono::steady_clock;

  Progress* progress_;
  double fraction_;
  const char* phase_;
  std::thread::id thread_;
  mutable Clock::time_point last_;
};

} // namespace medial

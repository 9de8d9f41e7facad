#pragma once

#include <chrono>
#include <deque>

namespace medial::app
{

/// Frames per second over the last drawings.
class FrameRate
{
public:
  using Clock = std::chrono::steady_clock;

  /// Counts a drawing, and forgets those more than two seconds before it.
  void tick(Clock::time_point now = Clock::now());

  /// 0 until there were two drawings within two seconds.
  double perSecond() const;

private:
  std::deque<Clock::time_point> drawings_;
};

} // namespace medial::app

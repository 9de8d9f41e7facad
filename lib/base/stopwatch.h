#pragma once

#include <chrono>

namespace medial
{

/// Adds the wall-clock seconds of its lifetime to a total.
class Stopwatch
{
public:
  explicit Stopwatch(double& total)
    : total_(total)
    , start_(Clock::now())
  {
  }
  ~Stopwatch() { total_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double& total_;
  Clock::time_point start_;
};

/// Runs `work` and adds its wall-clock seconds to `total`.
template <typename F>
auto timed(double& total, F&& work)
{
  const Stopwatch watch(total);
  return work();
}

} // namespace medial

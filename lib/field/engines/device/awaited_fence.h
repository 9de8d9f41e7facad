#pragma once

#include "gl/gl_objects.h"

#include <chrono>
#include <cstdint>

namespace medial
{

/// Tells when the device has done what it was given. GPU thread only.
class AwaitedFence
{
public:
  /// To be called after the commands that are waited for.
  void set();
  /// Waits for them, for a while.
  /// @throws Error NoGpu if the device was reset or does not finish.
  bool isReached(std::uint64_t nanoseconds);

private:
  using Clock = std::chrono::steady_clock;

  gl::Fence fence_;
  Clock::time_point started_;
};

} // namespace medial

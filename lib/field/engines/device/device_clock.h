#pragma once

#include "gl/gl_objects.h"
#include "medial/run_statistics.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// Measures phases on the device itself, by its timestamps. GPU thread only.
class DeviceClock
{
public:
  using Phase = double RunStatistics::DeviceSeconds::*;

  /// From here on the time belongs to a phase; null for none.
  void begin(Phase phase);
  /// Adds the seconds so far, once the device has done all of the work, and starts anew.
  void collect(RunStatistics::DeviceSeconds& seconds);
  /// Forgets what has been measured.
  void reset() { phases_.clear(); }

private:
  std::vector<gl::Query> queries_; ///< as many as there have ever been phases at once
  std::vector<Phase> phases_;
};

} // namespace medial

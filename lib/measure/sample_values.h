#pragma once

#include "base/run.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Checks a number of samples.
/// @throws Error InvalidInput if it is outside its range.
void checkSampleCount(std::int64_t samples);

/// Computes value(i) for i in [0, count), on the threads of the current arena.
template <typename Value>
std::vector<double> sampleValues(const Run& run, std::size_t count, const char* phase,
  const Value& value)
{
  constexpr std::size_t kBatch = 16384;
  std::vector<double> values(count);
  for (std::size_t first = 0; first < count; first += kBatch)
  {
    run.report(static_cast<double>(first) / static_cast<double>(count), phase);
    tbb::parallel_for(first, std::min(count, first + kBatch),
      [&](std::size_t i) { values[i] = value(i); });
  }
  return values;
}

} // namespace medial

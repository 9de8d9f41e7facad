#pragma once

#include "blocked_range.h"

namespace tbb
{

template <typename Value, typename Result, typename Body, typename Reduction>
Result parallel_reduce(const blocked_range<Value>& range, const Result& identity, const Body& body,
  const Reduction& reduction)
{
  std::mutex mutex;
  Result result = identity;
  stand_in::forParts(range.size(),
    [&](std::size_t begin, std::size_t end)
    {
      const blocked_range<Value> part(range.begin() + static_cast<Value>(begin),
        range.begin() + static_cast<Value>(end));
      const Result one = body(part, identity);
      const std::lock_guard<std::mutex> lock(mutex);
      result = reduction(result, one);
    });
  return result;
}

} // namespace tbb

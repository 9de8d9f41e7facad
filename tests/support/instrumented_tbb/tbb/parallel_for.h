#pragma once

#include "blocked_range.h"

namespace tbb
{

template <typename Value, typename Body>
void parallel_for(const blocked_range<Value>& range, const Body& body)
{
  stand_in::forParts(range.size(),
    [&](std::size_t begin, std::size_t end)
    {
      body(blocked_range<Value>(range.begin() + static_cast<Value>(begin),
        range.begin() + static_cast<Value>(end)));
    });
}

template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body)
{
  if (first >= last)
  {
    return;
  }
  parallel_for(blocked_range<Index>(first, last),
    [&](const blocked_range<Index>& range)
    {
      for (Index i = range.begin(); i != range.end(); ++i)
      {
        body(i);
      }
    });
}

} // namespace tbb

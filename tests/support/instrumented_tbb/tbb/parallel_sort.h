#pragma once

#include <algorithm>

namespace tbb
{

template <typename Iterator>
void parallel_sort(Iterator begin, Iterator end)
{
  std::sort(begin, end);
}

template <typename Iterator, typename Compare>
void parallel_sort(Iterator begin, Iterator end, const Compare& compare)
{
  std::sort(begin, end, compare);
}

} // namespace tbb

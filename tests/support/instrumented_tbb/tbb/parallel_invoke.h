#pragma once

#include "stand_in.h"

#include <cstddef>
#include <functional>

namespace tbb
{

template <typename... Tasks>
void parallel_invoke(const Tasks&... tasks)
{
  const std::function<void()> all[] = { std::cref(tasks)... };
  stand_in::forParts(sizeof...(tasks),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i != end; ++i)
      {
        all[i]();
      }
    });
}

} // namespace tbb

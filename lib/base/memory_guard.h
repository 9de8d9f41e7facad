#pragma once

#include "medial/error.h"

#include <cstdint>
#include <new>
#include <string>

namespace medial
{

/// Runs `work` and turns std::bad_alloc into Error OutOfMemory.
template <typename F>
auto withMemoryErrors(std::int64_t gridPoints, F&& work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory,
      "out of memory for a field of " + std::to_string(gridPoints) + " grid points");
  }
}

} // namespace medial

#pragma once

#include "medial/common/error.h"

#include <cstdint>
#include <new>
#include <string>

namespace medial
{

/// Runs `work`, turning std::bad_alloc into Error OutOfMemory.
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

/// Checks that arrays over a grid fit into the memory that is left, before they are allocated:
/// Linux hands out memory that it does not have and ends the process later, and VTK's arrays abort
/// it. Nothing happens where the system does not tell how much is left.
/// @throws Error OutOfMemory with both numbers.
void requireMemory(std::int64_t gridPoints, std::int64_t bytesPerPoint);

} // namespace medial

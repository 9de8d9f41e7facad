#pragma once

#include <cstddef>
#include <cstdint>

namespace medial
{

/// Bytes of memory that can still be had, by Linux's estimate and the limit of the process's
/// control group (version 2); the largest number where neither is known.
std::uint64_t availableMemory();

/// Throws Error OutOfMemory where `bytesPerPoint` for each point of a grid are more than that: the
/// system would grant them, and end the process when it uses them.
void requireMemory(std::int64_t gridPoints, std::size_t bytesPerPoint);

} // namespace medial

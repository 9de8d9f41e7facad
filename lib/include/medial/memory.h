#pragma once

#include "medial/export.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace medial
{

/// Bytes of memory that can still be had, by Linux's estimate and the limits of the process's
/// control groups (version 2); the largest number where neither is known.
MEDIAL_EXPORT std::uint64_t availableMemory();

/// Throws Error OutOfMemory where `bytes` are more than that: the system would grant them, and end
/// the process when it uses them.
/// @param what for the message: "WHAT needs 12 MiB, but only 10 MiB are available".
MEDIAL_EXPORT void requireMemory(const std::string& what, std::uint64_t bytes);

/// The same for `bytesPerPoint` for each point of a grid.
MEDIAL_EXPORT void requireMemory(std::int64_t gridPoints, std::size_t bytesPerPoint);

} // namespace medial

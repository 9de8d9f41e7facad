#pragma once

#include "medial/export.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace medial
{

/// Returns how many bytes of memory are still available, by Linux's estimate and the limits of the
/// process's control groups (version 2); the largest number if neither is known.
MEDIAL_EXPORT std::uint64_t availableMemory();

/// Checks that `bytes` of memory are available. Without this check the system would grant them, and
/// then kill the process for using them.
/// @param what subject of the message: "WHAT needs 12 MiB, but only 10 MiB are available".
/// @throws Error OutOfMemory if `bytes` exceed availableMemory().
MEDIAL_EXPORT void requireMemory(const std::string& what, std::uint64_t bytes);

/// The same for a grid with `bytesPerPoint` bytes per point.
MEDIAL_EXPORT void requireMemory(std::int64_t gridPoints, std::size_t bytesPerPoint);

} // namespace medial

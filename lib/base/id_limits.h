#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace medial
{

/// Largest number of elements whose ids, or numbers, are 32 bits wide.
constexpr std::int64_t kMaxIds = std::numeric_limits<std::int32_t>::max();
/// Largest number of cell corners of a mesh. Each adds at most four sites, whose ids are 32 bits
/// wide.
constexpr std::int64_t kMaxCorners = (std::int64_t{ 1 } << 29) - 1;
/// Largest number of places where an axis crosses the grid. Each adds at most four points.
constexpr std::int64_t kMaxCrossings = kMaxCorners;

/// Refuses what has too many elements: "the mesh has 3000000000 sites, more than 2147483647".
/// @param subject begins the message: "the mesh".
/// @param elements what is counted: "sites".
/// @throws Error InvalidInput if `count` exceeds `max`.
void requireCount(const std::string& subject, std::int64_t count, const std::string& elements,
  std::int64_t max = kMaxIds);

} // namespace medial

#include "field/crossing.h"

#include "base/id_limits.h"
#include "medial/memory.h"

#include <cstdint>
#include <string>

namespace medial
{
namespace
{

/// Bytes that a crossing takes until the axis is finished. Measured between resolutions the program
/// took 520 more for each crossing, some of them for files.
constexpr std::size_t kAxisBytes = 400;

} // namespace

void requireRoomForAxis(std::size_t crossings)
{
  requireMemory("a medial axis selected from " + std::to_string(crossings) + " places or more",
    crossings * kAxisBytes);
  requireCount("the medial axis", static_cast<std::int64_t>(crossings),
    "places where it crosses the grid", kMaxCrossings);
}

} // namespace medial

#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// A directed edge where the triangles of a surface, as they count, do not cancel out.
struct RimEdge
{
  int from;
  int to;
  int weight; ///< how often the triangles run from `from` to `to`, > 0
};

/// A triangle that counts `weight` times, as seen from the side where its corners run
/// counterclockwise.
struct WeightedTriangle
{
  std::array<int, 3> corners;
  int weight;
};

/// Closes the holes of a surface: splits the rim into loops, and each loop in the middle, time and
/// again, so that most triangles are small and near the rim. Together with them the surface has no
/// rim.
std::vector<WeightedTriangle> lidsOf(const std::vector<RimEdge>& rim);

/// Returns the number of connected pieces of a rim.
std::int64_t countHoles(const std::vector<RimEdge>& rim);

} // namespace medial

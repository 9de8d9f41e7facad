#include "thinning/sound_cells.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace medial
{
namespace
{

/// Cells below this area (square voxels) or length (voxels) are not sound.
constexpr double kMinArea = 1e-3;
constexpr double kMinLength = 1e-3;

/// Area of a quad, length of a line.
template <std::size_t Count>
bool isSound(const std::array<std::int64_t, Count>& cell, const std::vector<BisectorPoint>& points)
{
  const auto at = [&](std::size_t corner) { return points[cell[corner]].position; };
  if constexpr (Count == 2)
  {
    return glm::distance(at(0), at(1)) >= kMinLength;
  }
  else
  {
    return 0.5 * glm::length(glm::cross(at(2) - at(0), at(3) - at(1))) >= kMinArea;
  }
}

/// Moves the points of cells that are not sound back. Returns whether any has moved.
template <typename Cells>
bool restore(const Cells& cells, const std::vector<BisectorPoint>& before,
  std::vector<BisectorPoint>& points)
{
  bool any = false;
  for (const auto& cell : cells)
  {
    if (isSound(cell, points))
    {
      continue;
    }
    for (const std::int64_t corner : cell)
    {
      if (points[corner].position != before[corner].position)
      {
        points[corner] = before[corner];
        any = true;
      }
    }
  }
  return any;
}

} // namespace

void keepCellsSound(const std::vector<BisectorPoint>& before, ThinnedAxis& axis)
{
  std::vector<BisectorPoint>& points = axis.points.points;
  // Each round moves at least one point back, and none leaves its old place again.
  while (restore(axis.quads, before, points) || restore(axis.lines, before, points))
  {
  }
}

} // namespace medial

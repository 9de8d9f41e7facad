#pragma once

#include "medial/grid.h"
#include "medial/ranks.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// A box of grid points, and what it takes to compute what lies there.
struct WorkBox
{
  Extent extent;
  double work; ///< of all of its points
};

/// Returns how large boxes of a grid are in which work is measured.
/// @param min smallest size, grid points along an edge; others are a power of two times as large.
/// @param enough number of boxes that suffices for each part.
int workBoxSize(const Grid& grid, int parts, int min, std::int64_t enough);

/// Cuts an extent in two, again and again, so that all parts have about the same work.
class WorkCut
{
public:
  /// @param step cuts lie at multiples of it from the extent's first point.
  /// @param halo points around each part whose work it has, too, at little less cost; rounded up to
  ///   steps.
  WorkCut(int step, int halo);

  /// @param boxes that lie in the extent; work is spread out evenly in each.
  /// @return one extent for each part. Where there are too few steps for all, some are empty.
  std::vector<Extent> parts(const Extent& extent, int count,
    const std::vector<WorkBox>& boxes) const;

private:
  std::vector<Extent> partsOfHalf(const Extent& extent, int count,
    const std::vector<WorkBox>& boxes) const;

  int step_;
  int halo_;
};

/// Cuts a grid into a part for each rank. Every rank calls it.
/// @param own boxes of this rank; those of all ranks cover the work once.
/// @return the same on every rank.
std::vector<Extent> partsOfWork(Communicator& communicator, const Grid& grid, const WorkCut& cut,
  const std::vector<WorkBox>& own);

} // namespace medial

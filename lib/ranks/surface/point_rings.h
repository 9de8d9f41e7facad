#pragma once

#include "ranks/surface/distributed_surface.h"

#include <utility>
#include <vector>

namespace medial
{

/// As many triangles without area in a row as pseudonormals see through, and one more.
constexpr int kMaxFlatRow = 17;

/// A triangle around a point.
struct RingFace
{
  int face;
  int isFlat; ///< 1 if it has no area
};

/// Which triangles of a distributed surface are around which points. Each rank knows it of its
/// share of the points.
class PointRings
{
public:
  /// Every rank calls it.
  /// @param surface must outlive this.
  PointRings(Communicator& communicator, const DistributedSurface& surface);

  /// Returns all triangles around some points, ascending. Every rank calls it.
  /// @param points numbers, any.
  std::vector<RingFace> around(Communicator& communicator, const std::vector<int>& points) const;

private:
  struct Corner
  {
    int point;
    RingFace at;
  };

  const DistributedSurface& surface_;
  std::vector<Corner> corners_; ///< at this rank's points, ascending
};

/// Returns the numbers, ascending, of all triangles around some points and around the corners of
/// those of them that have no area. Every rank calls it.
std::vector<int> facesAround(Communicator& communicator, const DistributedSurface& surface,
  std::vector<int> points);

} // namespace medial

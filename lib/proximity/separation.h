#pragma once

#include "proximity/element_distance.h"
#include "proximity/moving_mesh.h"
#include "proximity/pair_walk.h"

#include <vector>

namespace medial
{

/// Two elements and their closest points.
struct ClosestElements
{
  ClosePoints points;
  int elementA = -1;
  int elementB = -1;
};

/// Finds the closest points of two meshes that do not intersect. The elements of the last frame
/// bound the distance in the next one.
class Separation
{
public:
  /// Uses the threads of the current arena; the result does not depend on their number.
  const ClosestElements& find(const MovingMesh& a, const MovingMesh& b);

private:
  /// Returns a bound of the distance: the last elements, or those that a descent finds.
  static ClosestElements first(const MovingMesh& a, const MovingMesh& b,
    const ClosestElements& last);

  ClosestElements last_;
  WalkParts parts_;
  std::vector<ClosestElements> found_; ///< per part
};

} // namespace medial

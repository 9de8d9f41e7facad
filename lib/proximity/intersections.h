#pragma once

#include "proximity/moving_mesh.h"
#include "proximity/pair_walk.h"

#include <vector>

namespace medial
{

/// Slots of two elements that intersect.
struct SlotPair
{
  int a;
  int b;
};

/// Finds the elements of two meshes that intersect, exactly. Uses the threads of the current arena.
class Intersections
{
public:
  /// @param all whether to find all; otherwise one is enough.
  void find(const MovingMesh& a, const MovingMesh& b, bool all);

  /// Ascending by a and then b.
  const std::vector<SlotPair>& pairs() const { return pairs_; }

private:
  std::vector<SlotPair> pairs_;
  WalkParts parts_;
  std::vector<std::vector<SlotPair>> found_; ///< per part
  /// An intersection of the last frame, by elements.
  SlotPair last_{ -1, -1 };
};

} // namespace medial

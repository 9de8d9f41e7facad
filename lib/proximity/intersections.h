#pragma once

#include "proximity/moving_mesh.h"
#include "proximity/pair_walk.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// Slots of two elements that intersect.
struct SlotPair
{
  int a;
  int b;
};

/// Where the edges of two elements pass through the other.
struct PairCrossings
{
  std::array<glm::dvec3, 6> points;
  int count = 0;

  const glm::dvec3* begin() const { return points.data(); }
  const glm::dvec3* end() const { return points.data() + count; }
};

/// Returns where the edges of two elements cross the other.
PairCrossings crossingsOf(const Element& a, const Element& b);

/// Whether two meshes intersect after a translation of A, exactly for the rounded points.
bool intersect(const MovingMesh& a, const glm::dvec3& translation, const MovingMesh& b);

/// Finds the elements of two meshes that intersect, exactly. Uses the threads of the current arena.
class Intersections
{
public:
  /// @param all whether to find all; otherwise one is enough.
  void find(const MovingMesh& a, const MovingMesh& b, bool all);

  /// By ascending elements of A and then of B.
  const std::vector<SlotPair>& pairs() const { return pairs_; }
  /// Of every pair, if all were wanted; else none.
  const std::vector<PairCrossings>& crossings() const { return crossings_; }

private:
  void findCrossings(const MovingMesh& a, const MovingMesh& b);

  std::vector<SlotPair> pairs_;
  std::vector<PairCrossings> crossings_;
  WalkParts parts_;
  std::vector<std::vector<SlotPair>> found_; ///< per part
  /// An intersection of the last frame, by elements.
  SlotPair last_{ -1, -1 };
};

} // namespace medial

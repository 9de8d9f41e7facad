#pragma once

#include "base/disjoint_sets.h"
#include "proximity/intersections.h"
#include "proximity/penetration.h"

#include <vector>

namespace medial
{

/// Sorts what two meshes have in common into connected overlaps. Intersections of an element belong
/// together if the elements that it intersects share a point; points inside belong to the cut
/// elements around them.
class ContactManifolds
{
public:
  void find(const MovingMesh& a, const MovingMesh& b, const std::vector<SlotPair>& pairs,
    const Penetration& aInB, const Penetration& bInA);

  int count() const { return count_; }
  int ofPair(std::size_t pair) const { return manifolds_[pair]; }
  int ofEnclosedA(std::size_t enclosed) const { return manifolds_[firstA_ + enclosed]; }
  int ofEnclosedB(std::size_t enclosed) const { return manifolds_[firstB_ + enclosed]; }
  /// The manifold of a place whose element is cut or inside; -1 for others.
  int ofSlot(const DeepPlace& place) const;

private:
  /// An element of one mesh with a point of an element that it intersects.
  struct Corner
  {
    int slot;
    int point;
    int pair;
  };
  /// The first pair of a slot.
  struct FirstPair
  {
    int slot;
    int pair;
  };

  void joinPairs(const MovingMesh& mesh, const std::vector<SlotPair>& pairs, int SlotPair::*fixed,
    int SlotPair::*other);
  void joinEnclosed(const MovingMesh& mesh, const Penetration& penetration,
    const std::vector<FirstPair>& slots, std::size_t first);
  int manifoldOf(int slot, const MovingMesh& mesh, const std::vector<FirstPair>& slots,
    std::size_t first, const Penetration& penetration) const;
  static int firstPair(const std::vector<FirstPair>& slots, int slot);

  const MovingMesh* a_ = nullptr;
  const MovingMesh* b_ = nullptr;
  const Penetration* aInB_ = nullptr;
  const Penetration* bInA_ = nullptr;
  DisjointSets sets_; ///< pairs, then enclosed points of A, then those of B
  std::size_t firstA_ = 0;
  std::size_t firstB_ = 0;
  std::vector<Corner> corners_;
  std::vector<FirstPair> slotsA_; ///< ascending
  std::vector<FirstPair> slotsB_;
  std::vector<int> manifolds_;
  int count_ = 0;
};

} // namespace medial

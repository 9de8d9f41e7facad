#pragma once

#include "axis/bisector.h"
#include "base/disjoint_sets.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Sets of points that become one. The lowest point that was not moved represents its set, or the
/// lowest of all.
class Contraction
{
public:
  using Id = std::int64_t;

  explicit Contraction(const BisectorPoints& points);

  Id find(Id point) { return own_[sets_.find(point)]; }

  void join(Id p, Id q);

  /// Whether a point is in a set with others.
  bool isJoined(Id point) const { return joined_[point] != 0; }

  /// Whether the point that represents a set has others in it.
  bool standsForOthers(Id point) const { return large_[point] != 0; }

private:
  const BisectorPoints& points_;
  DisjointSets sets_;
  std::vector<Id> own_; ///< by the lowest point of the set
  std::vector<std::uint8_t> large_;
  std::vector<std::uint8_t> joined_;
};

/// Joins points that have the same position.
/// @param order the points to compare.
void joinEqualPoints(const BisectorPoints& points, std::vector<Contraction::Id> order,
  Contraction& contraction);

/// Tells which quads have short edges as long as none of their corners are joined. Edges that end
/// at a moved point may be longer.
std::vector<std::uint8_t> quadsWithShortEdges(const BisectorPoints& points,
  const std::vector<std::array<Contraction::Id, 4>>& quads);

/// Joins the ends of short edges. Returns whether there were any.
/// @param withShortEdges of the quads: quadsWithShortEdges().
bool joinShortEdges(const BisectorPoints& points,
  const std::vector<std::array<Contraction::Id, 4>>& quads,
  const std::vector<std::uint8_t>& withShortEdges, Contraction& contraction);

} // namespace medial

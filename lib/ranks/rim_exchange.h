#pragma once

#include "axis/border_rims.h"
#include "ranks/collective.h"
#include "ranks/grid_share.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace medial
{

/// The rims of a rank's part that go on in others. Each rank moves the vertices that it owns; the
/// neighbours of these on other ranks come from there.
class RimExchange
{
public:
  /// What is known of vertices.
  struct Vertices
  {
    std::function<std::int64_t(std::size_t vertex)> numberOf; ///< ascending
    std::function<glm::ivec3(std::size_t vertex)> cellOf;
  };

  /// Every rank calls it.
  /// @param rims of this rank; null if it has none.
  RimExchange(Communicator& communicator, const GridShare& share, const Vertices& vertices,
    BorderRims* rims);

  /// Sets the places of the neighbours. Every rank calls it.
  void update();

  /// Whether all neighbours were where this rank had found them by itself: their owners have them,
  /// and saw what is around them alike.
  bool alike() const { return alike_; }

private:
  /// Returns what the owners have for the vertices that this rank wants.
  RankLists<glm::dvec3> received();

  Communicator& communicator_;
  BorderRims* rims_;
  RankLists<std::int32_t> wanted_; ///< vertices of rims here, by their owners
  RankLists<std::int32_t> sent_;   ///< own ones that others want; -1 for those that are none
  bool alike_ = true;
};

} // namespace medial

#pragma once

#include "axis/sheets/border_rims.h"
#include "ranks/collective.h"
#include "ranks/field/grid_share.h"

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

  /// Moves the rims of all parts to their borders, unless ranks have seen them differently. Every
  /// rank calls it.
  /// @param locally runs what it is given on a rank that has rims, and nothing elsewhere.
  /// @return false on every rank if they have.
  template <typename Locally>
  bool move(const Locally& locally)
  {
    if (maximum(communicator_, alike_ ? 0 : 1) != 0)
    {
      return false;
    }
    for (int round = 0; round < BorderRims::kRounds; ++round)
    {
      locally([this] { rims_->beginRound(); });
      for (int pass = 0; pass < BorderRims::kPasses; ++pass)
      {
        this->update();
        locally([this, pass] { rims_->smooth(pass); });
      }
      locally([this] { rims_->settle(); });
    }
    return true;
  }

private:
  /// Sets the places of the neighbours. Every rank calls it.
  void update();
  /// Returns what the owners have for the vertices that this rank wants.
  RankLists<glm::dvec3> received();

  Communicator& communicator_;
  BorderRims* rims_;
  RankLists<std::int32_t> wanted_; ///< vertices of rims here, by their owners
  RankLists<std::int32_t> sent_;   ///< own ones that others want; -1 for those that are none
  /// Whether all neighbours were where this rank had found them by itself: their owners have them,
  /// and saw what is around them alike.
  bool alike_ = true;
};

} // namespace medial

#pragma once

#include "axis/sheets/border_rims.h"
#include "base/memory_guard.h"
#include "base/run.h"
#include "ranks/axis/rim_exchange.h"
#include "ranks/collective.h"
#include "ranks/field/grid_share.h"
#include "ranks/field/rank_field.h"

#include <algorithm>

namespace medial
{

/// A rank's part of the grid, where it makes the axis, and what it knows of the surface there.
class RankPart
{
public:
  /// All arguments must outlive this.
  RankPart(const GridShare& share, RankField& field, const Run& run)
    : share_(share)
    , field_(field)
    , run_(run)
  {
  }

  const GridShare& share() const { return share_; }
  RankField& field() const { return field_; }
  const Run& run() const { return run_; }

  /// Whether a halo around any part has all of the grid.
  bool coversGrid(int halo) const
  {
    const auto& last = share_.whole().max;
    return halo >= std::max({ last[0], last[1], last[2] });
  }

  /// Brings what can be closest in the part and a halo, and the lids of holes. Every rank calls it.
  void bring(Communicator& communicator, int halo) const
  {
    field_.bring(communicator, share_.withHalo(halo), {});
    if (field_.hasSign())
    {
      field_.closeHoles(communicator);
    }
  }

  /// Does work of this rank on its threads; not where it has no part of the grid.
  template <typename Work>
  void locally(const Work& work) const
  {
    const Extent& own = share_.own();
    if (!own.empty())
    {
      withMemoryErrors(own.pointCount(), [&] { run_.onThreads(work); });
    }
  }

  /// Moves the rims of all parts to their borders, unless ranks have seen them differently. Every
  /// rank calls it.
  /// @param rims of this rank; null without a part.
  /// @return false on every rank if they have.
  bool moveRims(Communicator& communicator, const RimExchange::Vertices& vertices,
    BorderRims* rims) const
  {
    RimExchange exchange(communicator, share_, vertices, rims);
    return exchange.move([this](const auto& work) { this->locally(work); });
  }

private:
  const GridShare& share_;
  RankField& field_;
  const Run& run_;
};

} // namespace medial

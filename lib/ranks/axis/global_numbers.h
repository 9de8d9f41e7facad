#pragma once

#include "ranks/collective.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Something that ranks have, by two numbers; no two are alike.
using GlobalKey = std::array<std::int64_t, 2>;

/// Numbers the keys of all ranks in ascending order. Each rank keeps a share of them.
class GlobalNumbers
{
public:
  /// Every rank calls it.
  /// @param own keys of this rank, each on one rank only.
  /// @param span first numbers of keys are in [0, span).
  GlobalNumbers(Communicator& communicator, const std::vector<GlobalKey>& own, std::int64_t span);

  /// Returns the numbers of some keys, of any ranks. Every rank calls it.
  std::vector<std::int64_t> of(Communicator& communicator,
    const std::vector<GlobalKey>& keys) const;

  std::int64_t total() const { return offsets_.total(); }

private:
  int homeOfKey(const GlobalKey& key) const { return homeOf(key[0], span_, ranks_); }

  int ranks_;
  std::int64_t span_;
  std::vector<GlobalKey> kept_; ///< ascending
  RankOffsets offsets_;
  int rank_;
};

} // namespace medial

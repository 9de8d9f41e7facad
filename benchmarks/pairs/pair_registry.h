#pragma once

#include "pairs/pair_method.h"

#include <functional>
#include <string>
#include <vector>

namespace medial::benchmark
{

struct PairMethodEntry
{
  std::string id;                      ///< as in --methods
  std::vector<PairQuestion> questions; ///< that it answers in a way
  std::function<std::unique_ptr<PairMethod>()> make;
};

/// The method that tells all, with which the answers of others are compared.
constexpr char kMedialAllId[] = "medial-all";

/// The methods for pairs of meshes that this build has; ours come first.
const std::vector<PairMethodEntry>& availablePairMethods();

/// Ids of methods for pairs, built or not.
const std::vector<std::string>& knownPairMethodIds();

} // namespace medial::benchmark

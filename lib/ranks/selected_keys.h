#pragma once

#include "ranks/collective.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Returns a number that is larger where a value is larger.
std::uint32_t ascending(float value);
/// Returns the value of such a number.
float valueOf(std::uint32_t number);

/// A number and the list that it is in.
struct ListedKey
{
  std::uint64_t key;
  int list;
};

/// Returns of each of some distributed lists the key at an index of its ascending order: digit by
/// digit, by counting how many keys have it. Every rank calls it.
/// @param keys of this rank.
/// @param indices one for each list, each below the number of its keys on all ranks.
std::vector<std::uint64_t> keysAt(Communicator& communicator, const std::vector<ListedKey>& keys,
  std::vector<std::int64_t> indices);

} // namespace medial

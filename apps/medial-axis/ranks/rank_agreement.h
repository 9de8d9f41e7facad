#pragma once

#include "medial/ranks.h"

#include <cstring>
#include <functional>
#include <type_traits>
#include <vector>

namespace medial::app
{

/// Returns one value of each rank.
template <typename T>
std::vector<T> gatheredValues(Communicator& communicator, const T& own)
{
  static_assert(std::is_trivially_copyable_v<T>);
  Communicator::Message message(sizeof(own));
  std::memcpy(message.data(), &own, sizeof(own));
  std::vector<T> values;
  for (const Communicator::Message& received : gathered(communicator, message))
  {
    values.emplace_back();
    std::memcpy(&values.back(), received.data(), sizeof(own));
  }
  return values;
}

/// Does work that may fail on some ranks only.
/// @throws Failure on every rank if any has failed: that of the first, which it names unless all
///   have the same.
void withSharedFailures(Communicator& communicator, const std::function<void()>& work);

/// Does work on the first rank alone. Every rank calls it.
/// @throws Failure on every rank if it has failed.
void withFailuresOfFirst(Communicator& communicator, const std::function<void()>& work);

} // namespace medial::app

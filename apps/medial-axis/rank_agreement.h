#pragma once

#include "medial/ranks.h"

#include <functional>
#include <vector>

namespace medial::app
{

/// Returns what each rank sends to all.
std::vector<Communicator::Message> gathered(Communicator& communicator,
  const Communicator::Message& own);

/// Does work that may fail on some ranks only.
/// @throws Failure on every rank if any has failed: that of the first.
void agree(Communicator& communicator, const std::function<void()>& work);

} // namespace medial::app

#pragma once

#include "medial/ranks.h"

#include <functional>
#include <string>

namespace medial::test
{

/// What the medial::Error says that work(communicator) ends with on every rank of so many, nothing
/// where it ends well.
std::string messageOfRanks(int ranks, const std::function<void(Communicator&)>& work);

} // namespace medial::test

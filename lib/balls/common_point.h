#pragma once

#include "balls/ball.h"

#include <vector>

namespace medial
{

/// Whether up to four balls have a common interior point.
bool haveCommonPoint(const std::vector<Ball>& balls);

} // namespace medial

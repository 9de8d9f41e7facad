#pragma once

#include "lib/proximity/integers.h"

#include <array>

namespace medial::test
{

/// A triangle, a segment or a point in integers, below 2^40.
using Corners = std::array<IntegerVector, 3>;

/// Whether two elements share no point, by separating axes. Exact.
bool areApart(const Corners& a, const Corners& b);

} // namespace medial::test

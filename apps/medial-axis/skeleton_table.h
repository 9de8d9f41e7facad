#pragma once

#include "medial/skeleton.h"

#include <iosfwd>

namespace medial::app
{

/// Writes a line of names, then one line for every branch, with commas between the values.
void writeSkeletonTable(const Skeleton& skeleton, std::ostream& stream);

} // namespace medial::app

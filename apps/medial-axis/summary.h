#pragma once

#include "computation.h"
#include "options.h"
#include "report.h"

namespace medial::app
{

/// Says in plain words on standard output what was read, computed and written, how long that took
/// and on which renderer; notes that the user should know of go to standard error.
void printSummary(const Options& options, const Result& result, const AppSeconds& seconds);

} // namespace medial::app

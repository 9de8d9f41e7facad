#pragma once

#include "computation.h"
#include "options.h"
#include "output_writer.h"
#include "report.h"

namespace medial::app
{

/// Prints on standard output what was read, computed and written, how long that took and on which
/// renderer. Notes go to standard error.
void printSummary(const Options& options, const Result& result, const OutputNotes& notes,
  const AppSeconds& seconds);

} // namespace medial::app

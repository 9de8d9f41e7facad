#pragma once

#include "options.h"
#include "output_writer.h"
#include "report.h"
#include "result.h"

#include <optional>

namespace medial::app
{

/// Prints on standard error what the user should know about the result. If the options
/// ask for quiet, only that the axis is not that of the side that was asked for.
void printNotes(const Options& options, const Result& result, const OutputNotes& notes);

/// The same about the sign, for an axis of a side.
void printSignNotes(const Options& options, const SignReport& sign, Side side);

/// Prints the figures of thickness on standard output.
void printThickness(const Options& options, const Thickness& thickness);

/// Prints on standard output how much an axis leaves out, if it is of the interior.
void printCoverage(const std::optional<AxisCoverage>& coverage);

/// Prints on standard output what was read, computed and written, how long that took and on which
/// renderer.
void printSummary(const Options& options, const Result& result, const OutputNotes& notes,
  const AppSeconds& seconds);

} // namespace medial::app

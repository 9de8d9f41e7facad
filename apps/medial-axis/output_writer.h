#pragma once

#include "input/surface.h"
#include "options.h"
#include "outputs.h"
#include "result.h"

#include <string>
#include <vector>

namespace medial::app
{

/// What the user should know about the files that were written.
struct OutputNotes
{
  long long curves = 0;          ///< polylines of --curves
  std::vector<std::string> page; ///< what --html has simplified
  double pictureSeconds = 0.0;   ///< that pictures took to draw and write
};

/// Writes all files that the options ask for, except the report.
/// @param result of the surface.
/// @throws Failure.
OutputNotes writeOutputs(const Options& options, Surface& surface, const Result& result,
  Outputs& outputs);

} // namespace medial::app

#pragma once

#include "options.h"
#include "result.h"

#include <filesystem>
#include <string>

namespace medial::app
{

/// Wall-clock seconds of what the program does around the computation.
struct AppSeconds
{
  double read = 0.0;
  double prepare = 0.0; ///< welding points, who shares them with whom, coarse skeletons
  double measure = 0.0; ///< topology and coverage of the axis
  double skeleton = 0.0;
  double thickness = 0.0; ///< with the values of its picture
  double pictures = 0.0;  ///< drawing and writing them
  double write = 0.0;     ///< all other files
  double total = 0.0;
};

/// The largest memory of the process so far.
double peakMemoryMiB();

/// The figures of a run as JSON text. Its keys are listed in docs/COMMAND-LINE.md, and a test
/// compares; what was not computed is null, or 0 for a count. Lengths are in world units.
std::string makeReport(const Result& result, const Options& options, const AppSeconds& seconds);

/// @throws Failure NoSpace if the file cannot be written completely. The message does not name it.
void writeReport(const std::string& report, const std::filesystem::path& file);

} // namespace medial::app

#pragma once

#include "medial/axis_measurement.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace medial::app
{

/// The command line of medial-measure.
struct MeasureCommand
{
  std::filesystem::path axis; ///< .vtp, .ply, .obj or .ma
  std::filesystem::path mesh; ///< what readSurface() reads
  std::filesystem::path json; ///< empty for none, - for standard output
  std::int64_t samples = kDefaultMeasureSamples;
  int threads = 0;
  bool quiet = false;
};

/// Reads the command line. Empty if the user asked for --help or --version; the answer is on
/// standard output then.
/// @throws Failure Usage.
std::optional<MeasureCommand> parseMeasureCommand(int argc, char** argv);

} // namespace medial::app

#pragma once

#include "medial/axis_measurement.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace medial::app
{

/// The command line of medial-measure.
struct MeasureOptions
{
  std::filesystem::path axis; ///< .vtp, .ply, .obj or .ma
  std::filesystem::path mesh; ///< what readMesh() reads
  std::filesystem::path json; ///< empty for none
  std::int64_t samples = kDefaultMeasureSamples;
  int threads = 0;
  bool quiet = false;
};

/// Reads the command line; nothing when the user asked for --help or --version, which are then
/// answered on standard output.
/// @throws Failure Usage.
std::optional<MeasureOptions> parseMeasureOptions(int argc, char** argv);

} // namespace medial::app

#pragma once

#include "medial/medial/evaluation/axis_evaluation.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace medial::app
{

/// The command line of medial-evaluate.
struct EvaluateOptions
{
  std::filesystem::path axis; ///< .vtp, .ply, .obj or .ma
  std::filesystem::path mesh; ///< what readMesh() reads
  std::filesystem::path json; ///< empty for none
  std::int64_t samples = kDefaultEvaluationSamples;
  int threads = 0;
  bool quiet = false;
};

/// Reads the command line; nothing when the user asked for --help or --version, which are then
/// answered on standard output.
/// @throws Failure Usage.
std::optional<EvaluateOptions> parseEvaluateOptions(int argc, char** argv);

} // namespace medial::app

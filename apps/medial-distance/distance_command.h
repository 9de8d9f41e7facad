#pragma once

#include "medial/sign_method.h"
#include "scan_input.h"

#include <filesystem>
#include <optional>

namespace medial::app
{

/// The command line of medial-distance.
struct DistanceCommand
{
  std::filesystem::path mesh;   ///< a mesh, or a scan
  ScanSurface scan;             ///< which surface to take from a scan
  std::filesystem::path points; ///< what readPointSet() reads
  std::filesystem::path output; ///< .vtp or .csv; empty for none
  std::filesystem::path image;  ///< .png; empty for none
  std::filesystem::path json;   ///< empty for none, - for standard output
  SignMethod sign = SignMethod::Auto;
  int threads = 0;
  bool quiet = false;
};

/// Reads the command line. Empty if the user asked for --help or --version; the answer is on
/// standard output then.
/// @throws Failure Usage.
std::optional<DistanceCommand> parseDistanceCommand(int argc, char** argv);

} // namespace medial::app

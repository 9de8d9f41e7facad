#pragma once

#include <filesystem>
#include <optional>

#include <vtkMedialAxis.h>

namespace medial::app
{

/// The command line, checked as far as that is possible without the mesh. Empty paths are outputs
/// that are not wanted.
struct Options
{
  std::filesystem::path input;
  std::filesystem::path output; ///< .vtp, .ply, .obj or .ma
  std::filesystem::path field;  ///< .vti
  std::filesystem::path image;  ///< .png
  std::filesystem::path report; ///< .json
  int resolution = 256;
  std::optional<double> spacing; ///< instead of resolution
  double padding = 0.05;
  double angle = 60.0;
  int side = vtkMedialAxis::INTERIOR;
  int representation = vtkMedialAxis::SURFACE;
  int signMethod = vtkMedialAxis::SIGN_AUTO;
  int evaluator = vtkMedialAxis::EVALUATOR_AUTO;
  int threads = 0;
  int memoryMiB = 0;
  bool requireGpu = false;
  bool quiet = false;
};

/// Reads the command line; nothing when the user asked for --help or --version, which are then
/// answered on standard output.
/// @throws Failure Usage.
std::optional<Options> parseOptions(int argc, char** argv);

/// Sets what the options say on the filter.
void applyOptions(const Options& options, vtkMedialAxis* filter);

} // namespace medial::app

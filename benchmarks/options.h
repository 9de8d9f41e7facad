#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace medial::benchmark
{

struct Options
{
  std::vector<std::string> suites;  ///< names in suites()
  std::vector<std::string> methods; ///< empty: all that a suite compares
  std::vector<std::string> meshes;  ///< empty: all of a suite
  std::vector<std::string> files;   ///< meshes that the suite of models measures besides its own
  std::filesystem::path output = "docs/benchmarks";
  int repeats = 5;
  int resolution = 0; ///< 0: each suite's own
  double timeCap = 40.0;
  double budget = 30.0;
  int maxTriangles = 2000000; ///< of the suite of triangles
  int checkedPoints = 10000;
  bool quick = false;
  /// To measure memory, the program starts itself with a method and a file that says what to
  /// compute.
  std::string memoryOf;
  std::filesystem::path problem;
};

/// Reads the command line. Sets the environment variable MEDIAL_MODELS for --models.
/// @return nothing if the program shall end at once, with `exitCode`.
std::optional<Options> parseOptions(int argc, char** argv, int& exitCode);

} // namespace medial::benchmark

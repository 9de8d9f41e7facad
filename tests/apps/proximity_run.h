#pragma once

#include "command_run.h"

#include "support/shapes.h"

#include <string>
#include <vector>

// Runs of medial-proximity.
namespace medial::test
{

/// A folder with a cube of side 2 at the origin, one of side 1 there, and medial-proximity to run
/// on them.
class ProximityRun : public ::testing::Test
{
protected:
  ProximityRun();

  /// The arguments for both cubes, the small one moved along x.
  std::vector<std::string> cubes(double x, const std::vector<std::string>& more = {}) const;

  /// Runs on cubes(), which must succeed.
  Outcome run(double x, const std::vector<std::string>& arguments = {}) const;

  /// The JSON of a run, which must succeed.
  static Json json(std::vector<std::string> arguments);
  /// The only pair of the only frame of run().
  Json pair(double x, const std::vector<std::string>& arguments = {}) const;

  /// Runs with all outputs: must end with one line on standard error and without a file.
  static std::string failure(int exitCode, std::vector<std::string> arguments,
    const RunOptions& options = {});

  TemporaryFolder folder;
  std::string large = folder.file("large.off");
  std::string small = folder.file("small.off");
};

} // namespace medial::test

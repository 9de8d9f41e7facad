#pragma once

#include "support/files.h"

#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

// Runs the built commands as a user would.
namespace medial::test
{

// Exit codes, as docs/COMMAND-LINE.md has them.
constexpr int kUsage = 2;
constexpr int kBadInput = 3;
constexpr int kNoGpu = 4;
constexpr int kNoSpace = 5;
constexpr int kFault = 70;
constexpr int kInterrupted = 130;

/// How a run ended. A signal that ended it counts as 128 + its number, as in a shell.
struct Outcome
{
  int exitCode = 0;
  std::string out;
  std::string err;
};

struct RunOptions
{
  std::vector<std::pair<std::string, std::string>> environment; ///< added to this process's
  std::filesystem::path folder; ///< where to run; this process's folder when empty
  std::filesystem::path output; ///< what standard output is, instead of Outcome::out
  long fileSizeLimit = 0;       ///< bytes that a file may grow to; 0 for no limit
  double interruptAfter = 0.0;  ///< seconds before a signal, sent once SIGINT is handled; 0: never
  int signal = SIGINT;          ///< that interrupts
};

Outcome runMedialAxis(const std::vector<std::string>& arguments, const RunOptions& options = {});
Outcome runMedialDistance(const std::vector<std::string>& arguments,
  const RunOptions& options = {});
Outcome runMedialMeasure(const std::vector<std::string>& arguments, const RunOptions& options = {});
Outcome runMedialProximity(const std::vector<std::string>& arguments,
  const RunOptions& options = {});
Outcome runMedialViewer(const std::vector<std::string>& arguments, const RunOptions& options = {});

} // namespace medial::test

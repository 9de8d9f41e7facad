#pragma once

#include <string>

namespace medial::benchmark
{

/// The machine on which the figures were taken.
struct Machine
{
  std::string renderer; ///< why there is none where there is none
  std::string version;
  std::string processor; ///< empty where the system does not tell
  unsigned cores = 0;
  std::string date; ///< of the start of the run, UTC
};

Machine describeMachine();

} // namespace medial::benchmark

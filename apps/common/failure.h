#pragma once

#include <stdexcept>
#include <string>

namespace medial::app
{

/// The exit code of a program.
enum class ExitCode
{
  Done = 0,
  BeyondLimits = 1, ///< everything was done, but a check that the user asked for failed
  Usage = 2,        ///< an option is unknown, misplaced or out of its range
  BadInput = 3,     ///< the mesh cannot be read or used
  NoGpu = 4,        ///< no usable OpenGL, or a software renderer with --require-gpu
  NoSpace = 5,      ///< out of memory, or an output cannot be written
  Fault = 70,       ///< the program itself is to blame: an exception that nobody expected
  Interrupted = 130
};

/// Ends the run. The message is one line that names the file or option, the value and what is
/// allowed.
class Failure : public std::runtime_error
{
public:
  Failure(ExitCode exitCode, const std::string& message)
    : std::runtime_error(message)
    , exitCode_(exitCode)
  {
  }

  ExitCode exitCode() const noexcept { return exitCode_; }

private:
  ExitCode exitCode_;
};

} // namespace medial::app

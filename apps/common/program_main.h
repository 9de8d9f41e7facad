#pragma once

#include <functional>

namespace medial::app
{

/// Runs a program's work with signal handlers in place. A failure becomes one line on standard
/// error, "name: what is wrong"; so does an exception that nobody expected, as a fault of the
/// program. Where `operator new` finds no memory the process ends at once, unless `work` takes the
/// handler away by std::set_new_handler(). What was printed must have reached standard output.
/// @return the exit code.
int runProgram(const char* name, const std::function<void()>& work);

/// Names one of several processes, for the line that says that it alone has run out of memory.
void nameProcess(int rank);

/// Whether this process prints no failure, since another one prints the same.
void muteReports(bool muted);

} // namespace medial::app

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

/// Reports the exception that is being handled, now.
/// @return the exit code.
int reportException();

/// Prints no failures from now on, since this process or another one has printed the same.
void muteReports();

} // namespace medial::app

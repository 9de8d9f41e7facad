#include "program_main.h"

#include "failure.h"
#include "interrupt.h"
#include "output/output_file.h"
#include "output/standard_output.h"
#include "vtk_messages.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

namespace medial::app
{
namespace
{

const char* programName = "";
bool reportsMuted = false;
char processName[32] = ""; ///< of one of several processes

/// Allocates nothing, since there may be no memory.
int report(ExitCode code, const char* kind, const char* message)
{
  if (reportsMuted)
  {
    return static_cast<int>(code);
  }
  std::fprintf(stderr, "%s: %s", programName, kind);
  for (; *message != 0; ++message)
  {
    std::fputc(*message == '\n' ? ' ' : *message, stderr);
  }
  std::fputc('\n', stderr);
  return static_cast<int>(code);
}

int reportFault(const char* message)
{
  return report(ExitCode::Fault, "a fault of the program: ", message);
}

int reportLackOfMemory()
{
  return report(ExitCode::NoSpace, processName, "not enough memory");
}

/// Whether the system refused to start a thread. TBB throws std::runtime_error then, whose message
/// ends with the system's.
bool isLackOfThreads(const std::exception& error)
{
  return std::strstr(error.what(), std::strerror(EAGAIN)) != nullptr;
}

/// Ends the program where memory runs out, rather than by std::bad_alloc: VTK's constructors do not
/// survive exceptions, and streams keep them to themselves.
[[noreturn]] void endWithoutMemory()
{
  OutputFile::removeTemporaries();
  std::_Exit(reportLackOfMemory());
}

/// For exceptions that leave a destructor or a thread.
[[noreturn]] void terminate()
{
  OutputFile::removeTemporaries();
  std::_Exit(std::current_exception() ? reportException() : reportFault("it was terminated"));
}

/// Does the work; reports what goes wrong.
int exitCodeOf(const std::function<void()>& work)
{
  try
  {
    const VtkMessages silence; // a failure is one line, and not also those of VTK
    work();
    return static_cast<int>(ExitCode::Done);
  }
  catch (...)
  {
    return reportException();
  }
}

} // namespace

int reportException()
{
  try
  {
    throw;
  }
  catch (const Failure& failure)
  {
    return report(failure.exitCode(), "", failure.what());
  }
  catch (const std::bad_alloc&)
  {
    return reportLackOfMemory();
  }
  catch (const std::exception& error)
  {
    return isLackOfThreads(error)
      ? report(ExitCode::NoSpace, "no memory for another thread: ", error.what())
      : reportFault(error.what());
  }
  catch (...)
  {
    return reportFault("an exception of an unknown type");
  }
}

void muteReports()
{
  reportsMuted = true;
}

void nameProcess(int rank)
{
  std::snprintf(processName, sizeof(processName), "rank %d: ", rank);
}

int runProgram(const char* name, const std::function<void()>& work)
{
  programName = name;
  installSignalHandlers();
  std::set_new_handler(endWithoutMemory);
  std::set_terminate(terminate);
  const int exitCode = exitCodeOf(work);
  const bool isDone = exitCode == static_cast<int>(ExitCode::Done) ||
    exitCode == static_cast<int>(ExitCode::BeyondLimits);
  // A summary that nobody gets is a lost output.
  return isDone ? std::max(exitCode, exitCodeOf(flushStandardOutput)) : exitCode;
}

} // namespace medial::app

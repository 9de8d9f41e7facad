#include "program_main.h"

#include "failure.h"
#include "interrupt.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace medial::app
{
namespace
{

const std::string kFault = "a fault of the program: ";
const char* programName = "";

std::string inOneLine(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// How the exception being handled ends a program.
Failure failureOfException()
{
  try
  {
    throw;
  }
  catch (const Failure& failure)
  {
    return failure;
  }
  catch (const std::bad_alloc&)
  {
    return { ExitCode::NoSpace, "not enough memory" };
  }
  catch (const std::system_error& error)
  {
    if (error.code() == std::errc::resource_unavailable_try_again)
    {
      return { ExitCode::NoSpace, std::string("the system has no more threads: ") + error.what() };
    }
    return { ExitCode::Fault, kFault + inOneLine(error.what()) };
  }
  catch (const std::exception& error)
  {
    return { ExitCode::Fault, kFault + inOneLine(error.what()) };
  }
  catch (...)
  {
    return { ExitCode::Fault, kFault + "an exception of an unknown type" };
  }
}

int report(const Failure& failure)
{
  std::fprintf(stderr, "%s: %s\n", programName, failure.what());
  return static_cast<int>(failure.exitCode());
}

/// For exceptions that leave a destructor or a thread.
[[noreturn]] void terminate()
{
  std::_Exit(
    report(std::current_exception() ? failureOfException()
                                    : Failure(ExitCode::Fault, kFault + "it was terminated")));
}

} // namespace

int runProgram(const char* name, const std::function<void()>& work)
{
  programName = name;
  installSignalHandlers();
  std::set_terminate(terminate);
  try
  {
    work();
    return static_cast<int>(ExitCode::Done);
  }
  catch (...)
  {
    return report(failureOfException());
  }
}

} // namespace medial::app

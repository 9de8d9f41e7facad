#include "program_main.h"

#include "failure.h"
#include "interrupt.h"

#include <cstdio>
#include <exception>
#include <new>

namespace medial::app
{
namespace
{

int fail(const char* name, ExitCode code, const char* message)
{
  std::fprintf(stderr, "%s: %s\n", name, message);
  return static_cast<int>(code);
}

} // namespace

int runProgram(const char* name, const std::function<void()>& work)
{
  installSignalHandlers();
  try
  {
    work();
    return static_cast<int>(ExitCode::Done);
  }
  catch (const Failure& failure)
  {
    return fail(name, failure.exitCode(), failure.what());
  }
  catch (const std::bad_alloc&)
  {
    return fail(name, ExitCode::NoSpace, "not enough memory");
  }
  catch (const std::exception& error)
  {
    return fail(name, ExitCode::NoSpace, error.what());
  }
}

} // namespace medial::app

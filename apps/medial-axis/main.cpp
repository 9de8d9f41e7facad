#include "failure.h"
#include "interrupt.h"
#include "options.h"
#include "run.h"

#include <cstdio>
#include <exception>
#include <new>

namespace
{

using medial::app::ExitCode;

int runProgram(int argc, char** argv)
{
  if (const auto options = medial::app::parseOptions(argc, argv))
  {
    medial::app::run(*options);
  }
  return static_cast<int>(ExitCode::Done);
}

int fail(ExitCode code, const char* message)
{
  std::fprintf(stderr, "medial-axis: %s\n", message);
  return static_cast<int>(code);
}

} // namespace

int main(int argc, char** argv)
{
  medial::app::installSignalHandlers();
  try
  {
    return runProgram(argc, argv);
  }
  catch (const medial::app::Failure& failure)
  {
    return fail(failure.exitCode(), failure.what());
  }
  catch (const std::bad_alloc&)
  {
    return fail(ExitCode::NoSpace, "not enough memory");
  }
  catch (const std::exception& error)
  {
    return fail(ExitCode::NoSpace, error.what());
  }
}

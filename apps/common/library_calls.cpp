#include "library_calls.h"

#include "failure.h"
#include "interrupt.h"

#include "medial/error.h"

#include <string>

namespace medial::app
{
namespace
{

ExitCode exitCodeOf(ErrorCode code)
{
  switch (code)
  {
    case ErrorCode::InvalidInput:
      return ExitCode::BadInput;
    case ErrorCode::NoGpu:
    case ErrorCode::ShaderBuild:
      return ExitCode::NoGpu;
    case ErrorCode::Cancelled:
      return ExitCode::Interrupted;
    case ErrorCode::GpuLimit:
    case ErrorCode::OutOfMemory:
      break;
  }
  return ExitCode::NoSpace;
}

} // namespace

bool Watch::cancelled()
{
  return interrupted();
}

void withFailures(const std::filesystem::path& input, const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    throwIfInterrupted();
    const ExitCode code = exitCodeOf(error.code());
    const std::string culprit = code == ExitCode::NoGpu ? "" : input.string() + ": ";
    throw Failure(code, culprit + error.what());
  }
}

} // namespace medial::app

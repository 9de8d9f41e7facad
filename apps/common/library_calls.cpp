#include "library_calls.h"

#include "failure.h"
#include "interrupt.h"

#include "medial/error.h"

#include <new>
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
    case ErrorCode::CannotRead:
      return ExitCode::BadInput;
    case ErrorCode::NoGpu:
    case ErrorCode::ShaderBuild:
      return ExitCode::NoGpu;
    case ErrorCode::Cancelled:
      return ExitCode::Interrupted;
    case ErrorCode::GpuLimit:
    case ErrorCode::OutOfMemory:
    case ErrorCode::CannotWrite:
      break;
  }
  return ExitCode::NoSpace;
}

// The input is not to blame for a failure of the GPU.
void runWithFailures(const std::string& culprit, const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    throwIfInterrupted();
    const std::string text = error.what();
    if (error.code() == ErrorCode::Cancelled && text.find("rank ") == 0)
    {
      throwInterrupted(text.substr(0, text.rfind("cancelled"))); // with the rank that was
    }
    const ExitCode code = exitCodeOf(error.code());
    throw Failure(code, (code == ExitCode::NoGpu ? "" : culprit) + error.what());
  }
  catch (const std::bad_alloc&)
  {
    throw Failure(ExitCode::NoSpace, culprit + "not enough memory");
  }
}

} // namespace

bool Watch::cancelled()
{
  return interrupted();
}

void PartWatch::report(double fraction, const char* /*phase*/)
{
  Watch::report(from_ + fraction * (to_ - from_), phase_.c_str());
}

void withFailures(const std::filesystem::path& input, const std::function<void()>& work)
{
  runWithFailures(input.string() + ": ", work);
}

void withFailures(const std::function<void()>& work)
{
  runWithFailures("", work);
}

} // namespace medial::app

#include "output/standard_output.h"

#include "failure.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace medial::app
{

namespace
{

/// Callers set errno to 0 before they write, so that the message gives the reason of this failure.
void requireWritten()
{
  // What failed before has left its mark on the stream, but its reason is gone.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
  {
    throw Failure(ExitCode::NoSpace,
      std::string("standard output: cannot be written") +
        (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
  }
}

} // namespace

void printText(const std::string& text)
{
  errno = 0;
  std::fputs(text.c_str(), stdout);
  requireWritten();
}

void flushStandardOutput()
{
  errno = 0;
  requireWritten();
}

void printFile(const std::filesystem::path& path, const std::string& content)
{
  if (!path.empty())
  {
    std::printf("wrote     %s: %s\n", path.c_str(), content.c_str());
  }
}

} // namespace medial::app

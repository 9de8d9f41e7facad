#include "standard_output.h"

#include "failure.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace medial::app
{

void printText(const std::string& text)
{
  errno = 0;
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
  {
    throw Failure(ExitCode::NoSpace,
      std::string("standard output: cannot be written: ") + std::strerror(errno));
  }
}

} // namespace medial::app

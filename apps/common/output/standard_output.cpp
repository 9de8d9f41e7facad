#include "output/standard_output.h"

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

void printFile(const std::filesystem::path& path, const std::string& content)
{
  if (!path.empty())
  {
    std::printf("wrote     %s: %s\n", path.c_str(), content.c_str());
  }
}

} // namespace medial::app

#include "volumes/positioned_file.h"

#include "failure.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace medial::app
{
namespace
{

static_assert(sizeof(off_t) == 8, "files beyond 2 GiB need offsets of 64 bits");

// The system writes less than 2 GiB at a time.
constexpr std::uint64_t kLargestWrite = std::uint64_t{ 1 } << 30;

[[noreturn]] void fail(int error)
{
  throw Failure(ExitCode::NoSpace, error != 0 ? std::strerror(error) : "write error");
}

} // namespace

PositionedFile::PositionedFile(const std::filesystem::path& file)
  : descriptor_(open(file.c_str(), O_WRONLY | O_CLOEXEC))
{
  if (descriptor_ < 0)
  {
    fail(errno);
  }
}

PositionedFile::~PositionedFile()
{
  if (descriptor_ >= 0)
  {
    ::close(descriptor_);
  }
}

void PositionedFile::write(const void* bytes, std::uint64_t count, std::uint64_t offset)
{
  const char* from = static_cast<const char*>(bytes);
  while (count > 0)
  {
    const ssize_t written =
      pwrite(descriptor_, from, std::min(count, kLargestWrite), static_cast<off_t>(offset));
    if (written > 0)
    {
      from += written;
      offset += static_cast<std::uint64_t>(written);
      count -= static_cast<std::uint64_t>(written);
    }
    else if (written == 0 || errno != EINTR)
    {
      fail(written == 0 ? 0 : errno);
    }
  }
}

void PositionedFile::close()
{
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0)
  {
    fail(errno);
  }
}

} // namespace medial::app

#include "volumes/gzip_file.h"

#include "failure.h"

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace medial::app
{
namespace
{

// Distances hardly get smaller by higher levels, which take three times as long.
constexpr char kMode[] = "wb1";
constexpr std::uint64_t kLargestWrite = std::uint64_t{ 1 } << 30;

[[noreturn]] void fail()
{
  throw Failure(ExitCode::NoSpace, errno != 0 ? std::strerror(errno) : "write error");
}

} // namespace

GzipFile::GzipFile(const std::filesystem::path& file)
  : file_(gzopen(file.c_str(), kMode))
{
  if (file_ == nullptr)
  {
    fail();
  }
}

GzipFile::~GzipFile()
{
  if (file_ != nullptr)
  {
    gzclose(file_);
  }
}

void GzipFile::write(const void* bytes, std::uint64_t count, std::uint64_t offset)
{
  if (offset != position_)
  {
    throw std::logic_error("a compressed file is written out of order");
  }
  const char* from = static_cast<const char*>(bytes);
  position_ += count;
  while (count > 0)
  {
    errno = 0;
    const int written =
      gzwrite(file_, from, static_cast<unsigned int>(std::min(count, kLargestWrite)));
    if (written <= 0)
    {
      fail();
    }
    from += written;
    count -= static_cast<std::uint64_t>(written);
  }
}

void GzipFile::close()
{
  gzFile_s* file = file_;
  file_ = nullptr;
  errno = 0;
  if (gzclose(file) != Z_OK)
  {
    fail();
  }
}

} // namespace medial::app

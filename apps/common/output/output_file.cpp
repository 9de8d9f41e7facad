#include "output/output_file.h"

#include "failure.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

[[noreturn]] void failToWrite(const fs::path& path, const std::string& why)
{
  throw Failure(ExitCode::NoSpace, path.string() + ": cannot be written: " + why);
}

// A replaced file keeps its mode; a new one gets the mode that the user's umask allows.
mode_t wantedMode(const fs::path& target)
{
  struct stat status = {};
  if (stat(target.c_str(), &status) == 0)
  {
    return status.st_mode & 0777;
  }
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

OutputFile* newest = nullptr; // of those with a temporary file
std::mutex newestMutex;       // nobody allocates while holding it

} // namespace

OutputFile::OutputFile(const fs::path& path)
  : path_(path)
{
  std::error_code error;
  target_ = fs::weakly_canonical(path, error);
  if (error)
  {
    failToWrite(path, error.message());
  }
  const fs::file_status status = fs::status(target_, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    failToWrite(path, "it exists and is not a regular file");
  }
  create();
  discard();
}

OutputFile::~OutputFile()
{
  discard();
}

fs::path OutputFile::open()
{
  create();
  return temporary_;
}

void OutputFile::create()
{
  // From here on nothing is allocated: a file that exists is known to the destructor.
  temporary_ = (target_.parent_path() / ("." + target_.filename().string() + ".XXXXXX")).string();
  std::unique_lock<std::mutex> lock(newestMutex);
  const int descriptor = mkstemp(temporary_.data());
  if (descriptor < 0)
  {
    const int error = errno;
    lock.unlock();
    temporary_.clear();
    failToWrite(path_, std::strerror(error));
  }
  previous_ = std::exchange(newest, this);
  lock.unlock();
  fchmod(descriptor, wantedMode(target_));
  close(descriptor);
}

void OutputFile::discard()
{
  const std::lock_guard<std::mutex> lock(newestMutex);
  if (!temporary_.empty())
  {
    unlink(temporary_.c_str());
    forget();
  }
}

void OutputFile::forget()
{
  OutputFile** link = &newest;
  while (*link != this)
  {
    link = &(*link)->previous_;
  }
  *link = previous_;
  temporary_.clear();
}

void OutputFile::removeTemporaries() noexcept
{
  // Held until the process has ended, so that no file comes after this.
  newestMutex.lock();
  for (const OutputFile* file = newest; file != nullptr; file = file->previous_)
  {
    unlink(file->temporary_.c_str());
  }
}

void OutputFile::commit()
{
  std::unique_lock<std::mutex> lock(newestMutex);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
  {
    const int error = errno;
    lock.unlock();
    failToWrite(path_, std::strerror(error));
  }
  forget();
}

void namingFile(const fs::path& path, const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Failure& failure)
  {
    if (failure.exitCode() != ExitCode::NoSpace)
    {
      throw;
    }
    failToWrite(path, failure.what());
  }
}

} // namespace medial::app

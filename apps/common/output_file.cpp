#include "output_file.h"

#include "failure.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

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
  open();
  unlink(temporary_.c_str());
  temporary_.clear();
}

OutputFile::~OutputFile()
{
  if (!temporary_.empty())
  {
    unlink(temporary_.c_str());
  }
}

const fs::path& OutputFile::open()
{
  std::string name = (target_.parent_path() / ("." + target_.filename().string())).string();
  name += ".XXXXXX";
  const int descriptor = mkstemp(name.data());
  if (descriptor < 0)
  {
    failToWrite(path_, std::strerror(errno));
  }
  fchmod(descriptor, wantedMode(target_));
  close(descriptor);
  temporary_ = name;
  return temporary_;
}

void OutputFile::commit()
{
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error)
  {
    failToWrite(path_, error.message());
  }
  temporary_.clear();
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

#include "output/output_folder.h"

#include "failure.h"

#include <system_error>

namespace medial::app
{

OutputFolder::OutputFolder(const std::filesystem::path& path)
  : path_(path)
{
  std::error_code error;
  made_ = std::filesystem::create_directory(path, error);
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored))
  {
    throw Failure(ExitCode::NoSpace,
      path.string() +
        ": cannot be made: " + (error ? error.message() : "it exists and is not a folder"));
  }
}

OutputFolder::~OutputFolder()
{
  if (made_)
  {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored); // fails where there are files in it
  }
}

} // namespace medial::app

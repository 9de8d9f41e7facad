#include "output/output_files.h"

#include "interrupt.h"
#include "output/standard_output.h"

#include <algorithm>

namespace medial::app
{

void OutputFiles::add(const std::filesystem::path& path)
{
  if (!path.empty() && path != kStandardOutput)
  {
    files_.emplace_back(path);
  }
}

void OutputFiles::write(const std::filesystem::path& path,
  const std::function<void(const std::filesystem::path& file)>& write)
{
  const auto output = std::find_if(files_.begin(), files_.end(),
    [&path](const OutputFile& file) { return file.path() == path; });
  if (output == files_.end())
  {
    return;
  }
  throwIfInterrupted();
  namingFile(path, [&] { write(output->open()); });
}

void OutputFiles::commit()
{
  throwIfInterrupted();
  for (OutputFile& file : files_)
  {
    file.commit();
  }
}

} // namespace medial::app

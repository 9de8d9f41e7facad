#include "outputs.h"

#include "interrupt.h"

#include <algorithm>

namespace medial::app
{

Outputs::Outputs(const Options& options)
{
  if (!options.field.empty())
  {
    field_.emplace(options.field);
  }
  for (const auto* path : { &options.output, &options.curves, &options.image, &options.html,
         &options.thickness, &options.thicknessImage, &options.report })
  {
    if (!path->empty())
    {
      files_.emplace_back(*path);
    }
  }
}

void Outputs::write(const std::filesystem::path& path,
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

void Outputs::commit()
{
  throwIfInterrupted();
  for (OutputFile& file : files_)
  {
    file.commit();
  }
  if (field_)
  {
    field_->commit();
  }
}

} // namespace medial::app

#include "outputs.h"

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
    files_.add(*path);
  }
}

void Outputs::commit()
{
  files_.commit();
  if (field_)
  {
    field_->commit();
  }
}

} // namespace medial::app

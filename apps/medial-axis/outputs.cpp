#include "outputs.h"

#include "standard_output.h"

namespace medial::app
{

Outputs::Outputs(const Options& options)
{
  if (!options.field.empty())
  {
    field_.emplace(options.field, options.fieldArrays, options.band.value_or(kDefaultBand));
  }
  for (const auto* path :
    { &options.output, &options.curves, &options.skeleton, &options.skeletonTable, &options.image,
      &options.html, &options.thickness, &options.thicknessImage, &options.thinRegions })
  {
    files_.add(*path);
  }
  if (options.report != kStandardOutput)
  {
    files_.add(options.report);
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

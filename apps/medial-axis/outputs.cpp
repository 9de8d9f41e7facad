#include "outputs.h"

namespace medial::app
{

Outputs::Outputs(const Options& options)
{
  if (!options.field.empty())
  {
    field_.emplace(options.field, options.fieldArrays, kDistanceName,
      options.band.value_or(kDefaultBand));
  }
  if (!options.localThickness.empty())
  {
    localThickness_.emplace(options.localThickness, FieldSelection{ true }, kLocalThicknessName);
  }
  for (const auto* path : { &options.output, &options.curves, &options.skeleton,
         &options.skeletonTable, &options.image, &options.html, &options.histogram,
         &options.thickness, &options.thicknessImage, &options.thinRegions })
  {
    files_.add(*path);
  }
  files_.add(options.report);
}

void Outputs::commit()
{
  files_.commit();
  for (std::optional<FieldOutput>* field : { &field_, &localThickness_ })
  {
    if (*field)
    {
      (*field)->commit();
    }
  }
}

} // namespace medial::app

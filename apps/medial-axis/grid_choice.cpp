#include "grid_choice.h"

#include "medial/skeleton_resolution.h"

namespace medial::app
{

Grid gridOf(const Bounds& bounds, const Options& options)
{
  if (options.spacing)
  {
    const double spacing = *options.spacing;
    return makeGridWithSpacing(bounds, { spacing, spacing, spacing }, options.padding);
  }
  return makeGrid(bounds, options.resolution.value_or(kDefaultResolution), options.padding);
}

void chooseResolution(const Options& options, Progress& progress, Result& result)
{
  const Bounds bounds = result.mesh.bounds();
  MedialAxisOptions ofAxis = libraryOptions(options, bounds.diagonal());
  ofAxis.field.execution.progress = &progress;
  SkeletonOptions ofSkeleton = skeletonOptions(options);
  ofSkeleton.execution.progress = &progress;
  result.chosenResolution =
    chooseSkeletonResolution(result.mesh, result.connectivity, ofAxis, ofSkeleton, options.padding);
  result.grid = makeGrid(bounds, result.chosenResolution->resolution, options.padding);
}

} // namespace medial::app

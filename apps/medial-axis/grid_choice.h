#pragma once

#include "options.h"
#include "result.h"

#include "medial/execution.h"
#include "medial/grid.h"

namespace medial::app
{

/// The grid around a mesh, where the options tell it.
/// @throws Error InvalidInput.
Grid gridOf(const Bounds& bounds, const Options& options);

/// The grid of --resolution auto, which takes skeletons to choose; they are kept in the result.
/// @param result has the mesh and its connectivity; gets chosenResolution and grid.
/// @param progress of the skeletons; may cancel.
/// @throws Error.
void chooseResolution(const Options& options, Progress& progress, Result& result);

} // namespace medial::app

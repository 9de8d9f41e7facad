#pragma once

#include "measure_options.h"

namespace medial::app
{

/// Reads axis and mesh, measures, and leaves table and JSON file.
/// @throws Failure.
void runMeasure(const MeasureOptions& options);

} // namespace medial::app

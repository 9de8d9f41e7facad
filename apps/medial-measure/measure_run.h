#pragma once

#include "measure_command.h"

namespace medial::app
{

/// Reads axis and mesh, measures, and writes table and JSON file.
/// @throws Failure.
void runMeasure(const MeasureCommand& command);

} // namespace medial::app

#pragma once

#include "evaluate_options.h"

namespace medial::app
{

/// Reads axis and mesh, measures, and leaves table and JSON file.
/// @throws Failure.
void runEvaluation(const EvaluateOptions& options);

} // namespace medial::app

#pragma once

#include "input/surface.h"
#include "options.h"
#include "progress_bar.h"
#include "result.h"
#include "volumes/field_output.h"

namespace medial::app
{

/// The mesh as the filters see it, and its grid, which with --resolution auto takes skeletons.
/// @throws Failure.
Result prepare(const Surface& surface, const Options& options, ProgressBar& bar);

/// Computes the axis, if an option asks for it, and the field, which goes to disk meanwhile, in one
/// pass over the grid. Does nothing if neither is wanted, and leaves a field without an axis to
/// computeLocalThickness() if that is wanted.
/// @param field null if it is not wanted.
/// @throws Failure.
void compute(const Options& options, FieldOutput* field, ProgressBar& bar, Result& result);

/// Computes the skeleton from the axis, if an option asks for it.
/// @throws Failure.
void computeSkeleton(const Options& options, ProgressBar& bar, Result& result);

/// Computes local thickness, which goes to disk meanwhile. Does nothing if it is not wanted.
/// @param image null if it is not wanted.
/// @param field where the distance field goes, which compute() then leaves out; null if it is not
///   wanted.
/// @throws Failure.
void computeLocalThickness(const Options& options, FieldOutput* image, FieldOutput* field,
  ProgressBar& bar, Result& result);

/// Computes the thickness, as far as options ask for it.
/// @param surface the one that the mesh of the result was made from.
/// @throws Failure; Usage for limits that contradict each other.
void computeThickness(const Options& options, Surface& surface, ProgressBar& bar, Result& result);

} // namespace medial::app

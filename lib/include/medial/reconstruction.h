#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/medial_model.h"

#include <vector>

namespace medial
{

/// What is reconstructed.
struct ReconstructionOptions
{
  bool interpolate = true; ///< balls, cones and wedges; otherwise the balls only
  Execution execution;     ///< threads, progress and cancelling
};

/// Bounds of all balls of a model, world units.
/// @throws Error as checkMedialModel().
MEDIAL_EXPORT Bounds modelBounds(const MedialModel& model);

/// Signed distance, negative inside, to the union of balls, cones and wedges at the points of a
/// grid, x fastest, for the zero contour. Within three voxels of the union's surface it is the
/// minimum of the signed distances to the primitives, which outside is the exact one; elsewhere
/// only the sign is right, and that the surface is farther away.
///
/// @throws Error as checkMedialModel() and validateGrid(), and InvalidInput for a negative number
/// of
///   threads; Cancelled.
MEDIAL_EXPORT std::vector<float> computeReconstruction(const MedialModel& model, const Grid& grid,
  const ReconstructionOptions& options = {});

} // namespace medial

#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/medial_model.h"

#include <vector>

namespace medial
{

/// How a model is reconstructed.
struct ReconstructionOptions
{
  bool interpolate = true; ///< balls, cones and wedges; otherwise the balls only
  Execution execution;     ///< threads, progress and cancelling
};

/// Returns the bounds of all balls of a model, world units.
/// @throws Error as checkMedialModel().
MEDIAL_EXPORT Bounds modelBounds(const MedialModel& model);

/// Computes the signed distance, negative inside, from the points of a grid to the union of balls,
/// cones and wedges. Its zero contour is the reconstruction. Within three voxels of the union's
/// surface the value is the minimum of the signed distances to the primitives, which is exact
/// outside. Farther away only the sign is exact; the magnitude is still more than three voxels.
///
/// @return one value per grid point, x fastest, world units.
/// @throws Error as checkMedialModel() and validateGrid(), and InvalidInput for a negative number
///   of threads; OutOfMemory; Cancelled.
MEDIAL_EXPORT std::vector<float> computeReconstruction(const MedialModel& model, const Grid& grid,
  const ReconstructionOptions& options = {});

} // namespace medial

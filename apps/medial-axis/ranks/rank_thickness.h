#pragma once

#include "options.h"
#include "progress_bar.h"
#include "ranks/rank_input.h"
#include "result.h"

#include "medial/ranks.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <vector>

namespace medial::app
{

/// What several processes compute of the thickness.
struct RankThickness
{
  /// Of this rank's piece; on the first rank, where there are limits, of `mesh`. Its figures are
  /// those of the whole.
  Thickness thickness;
  /// The piece with the values, where it goes into a file of its own.
  vtkSmartPointer<vtkPolyData> piece;
  std::vector<std::int64_t> triangles; ///< how many each rank has
  RankCounts counts;

  ///@{
  /// On the first rank.
  TriangleMesh mesh;                    ///< the triangles beyond limits
  std::vector<ThicknessRegion> regions; ///< of the whole, with triangles of `mesh`
  vtkSmartPointer<vtkPolyData> surface; ///< the whole with the values, where a file needs it
  ///@}
};

/// Whether the first rank needs the whole mesh for the thickness: to write it into one file.
bool needsWholeForThickness(const Options& options);

/// Computes the thickness, as far as options ask for it. Every rank calls it.
/// @param share gives up the whole mesh.
/// @throws Failure on every rank.
RankThickness computeThickness(const Options& options, Communicator& communicator, Share& share,
  ProgressBar& bar);

/// Ends a run whose thickness is beyond its limits, as requireNoRegions(), on every rank.
/// @param result of the first rank.
void requireNoRegions(const Options& options, Communicator& communicator, const Result& result);

} // namespace medial::app

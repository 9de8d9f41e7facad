#pragma once

#include "computation.h"
#include "options.h"
#include "progress_bar.h"
#include "ranks/rank_input.h"

#include "medial/ranks.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace medial::app
{

/// What several processes compute of the thickness.
struct RankThickness
{
  Thickness thickness; ///< of this rank's piece, with the figures of the whole
  /// The piece with the values, where it goes into a file of its own.
  vtkSmartPointer<vtkPolyData> piece;
  std::vector<std::int64_t> triangles; ///< how many each rank has
  RankCounts counts;

  ///@{
  /// Of the whole surface, on the first rank, where a file or limits need it.
  TriangleMesh mesh;
  std::optional<Subdivision> fineMesh;
  std::vector<ThicknessRegion> regions;
  vtkSmartPointer<vtkPolyData> surface; ///< with the values
  ///@}
};

/// Whether the first rank needs the whole mesh for the thickness: to write it into one file, or to
/// find regions.
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

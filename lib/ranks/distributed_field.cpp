#include "base/memory_guard.h"
#include "base/run.h"
#include "medial/ranks.h"
#include "ranks/collective.h"
#include "ranks/counting_communicator.h"
#include "ranks/rank_field.h"

namespace medial
{

RunStatistics computeDistanceField(Communicator& communicator, const SurfacePiece& piece,
  const Grid& grid, const Extent& extent, FieldSink& sink, const DistanceFieldOptions& options,
  RankCounts* counts)
{
  CountingCommunicator counting(communicator);
  RunStatistics statistics;
  agree(counting,
    [&]
    {
      checkFieldOfRanks(grid, extent, options);
      const Run run(options.execution);
      RankField field(counting, piece, grid, extent, extent, options, run, statistics);
      if (!extent.empty())
      {
        withMemoryErrors(extent.pointCount(), [&] { field.compute(extent, sink); });
      }
      run.report(1.0, "distance field");
      if (counts != nullptr)
      {
        *counts = countsOf(field, counting);
      }
    });
  return statistics;
}

} // namespace medial

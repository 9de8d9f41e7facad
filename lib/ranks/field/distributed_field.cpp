#include "base/memory_guard.h"
#include "base/run.h"
#include "medial/compute_distance_field.h"
#include "medial/ranks.h"
#include "ranks/collective.h"
#include "ranks/counting_communicator.h"
#include "ranks/field/rank_field.h"
#include "ranks/whole_piece.h"

#include <optional>

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
      const std::optional<WholePiece> whole =
        communicator.size() == 1 && !extent.empty() ? wholePiece(piece) : std::nullopt;
      if (whole)
      {
        DistanceFieldOptions wanted = options;
        wanted.engine = Engine::Processor;
        statistics = computeDistanceField(whole->mesh,
          analyseConnectivity(whole->mesh, options.execution), grid, extent, sink, wanted);
        setCounts(whole->mesh, counting, counts);
        return;
      }
      const Run run(options.execution);
      RankField field(counting, piece, grid, options, run, statistics);
      field.bring(counting, extent, extent);
      field.settle();
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

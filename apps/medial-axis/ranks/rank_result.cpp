#include "ranks/rank_result.h"

#include "coverage_policy.h"
#include "input/surface_reader.h"
#include "library_calls.h"
#include "ranks/mesh_pieces.h"
#include "ranks/rank_agreement.h"
#include "report.h"
#include "timer.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace medial::app
{
namespace
{

/// What a rank tells the others.
struct Figures
{
  RankFigures rank;
  std::int64_t polygons;
  std::int64_t fragments;
  std::int64_t groupTests;
  std::int64_t siteTests;
  std::int64_t candidatePairs;
  std::int64_t samples;
};

/// Adds up what ranks have counted. Times are those of this rank.
void addUp(Communicator& communicator, const Figures& own, Result& result)
{
  RunStatistics& sum = result.statistics;
  sum.polygons = sum.fragments = sum.groupTests = sum.siteTests = sum.candidatePairs = 0;
  sum.samples = 0;
  for (const Figures& figures : gatheredValues(communicator, own))
  {
    result.ranks.push_back(figures.rank);
    sum.polygons += figures.polygons;
    sum.fragments += figures.fragments;
    sum.groupTests += figures.groupTests;
    sum.siteTests += figures.siteTests;
    sum.candidatePairs += figures.candidatePairs;
    sum.samples += figures.samples;
  }
}

/// The thickness at places that the axis leaves out. Rays go through all of the mesh, so the first
/// rank reads it once more; not where it lies in pieces.
void measurePlaces(const Options& options, Communicator& communicator, Result& result)
{
  if (isInPieces(options.input))
  {
    return;
  }
  withFailuresOfFirst(communicator,
    [&]
    {
      const Execution execution{ options.threads, nullptr };
      const TriangleMesh mesh = readSurface(options.input).toTriangleMesh();
      result.placeThickness =
        thicknessAt(result.coverage->places, mesh, analyseConnectivity(mesh, execution), execution);
    });
}

void measure(const Options& options, Communicator& communicator, const Share& share,
  const AxisPiece& axis, Result& result)
{
  withFailures(options.input,
    [&]
    {
      if (!options.report.empty())
      {
        result.axisTopology = topologyOf(communicator, axis);
      }
      if (wantsCoverage(options, result.axis.side))
      {
        result.coverage = coverageFor(options,
          [&](std::int64_t samples, double negligible)
          {
            return measureCoverage(communicator, share.piece, axis, coverageReach(result.grid),
              { samples, negligible, { options.threads, nullptr } });
          });
      }
    });
  if (result.coverage && result.coverage->uncoveredShare >= kNoticeableShare &&
    !result.coverage->places.empty())
  {
    measurePlaces(options, communicator, result);
  }
}

RankCounts together(const RankCounts& a, const RankCounts& b)
{
  return { std::max(a.ownTriangles, b.ownTriangles), std::max(a.heldTriangles, b.heldTriangles),
    a.bytesSent + b.bytesSent, a.exchanges + b.exchanges };
}

void takeThickness(RankThickness& thickness, Result& result)
{
  result.thicknessTriangles =
    std::accumulate(thickness.triangles.begin(), thickness.triangles.end(), std::int64_t{ 0 });
  result.thickness = std::move(thickness.thickness);
  result.mesh = std::move(thickness.mesh);
  result.regions = std::move(thickness.regions);
  result.thicknessSurface = thickness.surface;
}

} // namespace

Result resultOf(const Options& options, Communicator& communicator, const Share& share,
  const Grid& grid, const std::vector<Extent>& extents, RankComputed& computed)
{
  const MedialAxis& axis = computed.axis.axis;
  Result result;
  result.meshFigures = share.figures;
  result.grid = grid;
  result.statistics = computed.statistics;
  result.sign = computed.statistics.sign.method;
  result.axis.sign = axis.sign;
  result.axis.side = axis.side;
  result.axis.solid = axis.solid;
  result.axis.simplification = axis.simplification;
  result.axisPoints = computed.axis.points;
  result.axisCells = computed.axis.cells;
  if (options.wantsAxis())
  {
    const Timer measuring;
    measure(options, communicator, share, computed.axis, result);
    result.measureSeconds = measuring.seconds();
  }
  if (options.wantsThickness())
  {
    takeThickness(computed.thickness, result);
  }
  const RunStatistics& own = computed.statistics;
  const std::int64_t gridPoints = extents.empty() ? 0 : extents[communicator.rank()].pointCount();
  addUp(communicator,
    { { together(computed.counts, computed.thickness.counts), gridPoints, axis.cellCount(),
        peakMemoryMiB() },
      own.polygons, own.fragments, own.groupTests, own.siteTests, own.candidatePairs, own.samples },
    result);
  return result;
}

} // namespace medial::app

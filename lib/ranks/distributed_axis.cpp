#include "axis/axis_geometry.h"
#include "base/checkpoint.h"
#include "base/memory_guard.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "medial/ranks.h"
#include "pipeline/axis_stages.h"
#include "ranks/axis_assembly.h"
#include "ranks/collective.h"
#include "ranks/counting_communicator.h"
#include "ranks/inside_part.h"
#include "ranks/part_axis.h"
#include "ranks/rank_field.h"
#include "ranks/rim_exchange.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// Share of the work that is done once the crossings are selected.
constexpr double kSelected = 0.8;

void checkOptions(const MedialAxisOptions& options)
{
  checkAxisOptions(options);
  const bool preserve = options.topology == Topology::Preserve;
  if (preserve || options.maxSpheres > 0)
  {
    throw Error(ErrorCode::InvalidInput,
      std::string(preserve ? "preserved topology" : "a maximum number of spheres") +
        " needs the whole axis in one process");
  }
}

/// A crossing with the numbers that its sites have in the whole surface.
struct SharedCrossing
{
  Crossing crossing;
  std::int64_t number; ///< as AxisOrder
};

/// Gives the crossings of all parts to those that need them.
/// @param own those of this rank, and some of neighbours, which have them too.
std::vector<Crossing> withThoseAround(Communicator& communicator, const GridShare& share,
  const AxisOrder& order, const std::vector<std::int32_t>& siteNumbers, int halo,
  const std::vector<Crossing>& own)
{
  std::vector<SharedCrossing> shared;
  for (const Crossing& crossing : own)
  {
    if (share.owns(crossing.voxel))
    {
      shared.push_back({ crossing, order.ofCrossing(crossing) });
      shared.back().crossing.siteA = siteNumbers[crossing.siteA];
      shared.back().crossing.siteB = siteNumbers[crossing.siteB];
    }
  }
  shared = share.spread(communicator, shared, halo,
    [](const SharedCrossing& item) { return item.crossing.voxel; });
  std::sort(shared.begin(), shared.end(),
    [](const SharedCrossing& a, const SharedCrossing& b) { return a.number < b.number; });
  std::vector<std::pair<std::int32_t, std::int32_t>> sites; // in the whole, here
  for (std::size_t i = 0; i < siteNumbers.size(); ++i)
  {
    sites.emplace_back(siteNumbers[i], static_cast<std::int32_t>(i));
  }
  std::sort(sites.begin(), sites.end());
  const auto siteHere = [&](std::int32_t number)
  { return std::lower_bound(sites.begin(), sites.end(), std::pair(number, 0))->second; };
  const Extent part = share.withHalo(halo);
  std::vector<Crossing> crossings;
  for (SharedCrossing& item : shared)
  {
    glm::ivec3 end = item.crossing.voxel;
    ++end[item.crossing.axis];
    if (GridShare::isIn(part, end))
    {
      item.crossing.siteA = siteHere(item.crossing.siteA);
      item.crossing.siteB = siteHere(item.crossing.siteB);
      crossings.push_back(item.crossing);
    }
  }
  return crossings;
}

/// Moves the rims of all parts to their borders.
/// @param axis null for a rank without a part.
/// @param locally does work of this rank on its threads, and throws on every rank if it has failed
///   on any.
template <typename Locally>
void moveRims(Communicator& communicator, const GridShare& share, PartAxis* axis,
  const Locally& locally)
{
  BorderRims* const rims = axis != nullptr ? axis->rims() : nullptr;
  RimExchange exchange(communicator, share,
    { [&](std::size_t vertex) { return axis->numberOf(vertex); },
      [&](std::size_t vertex) { return axis->cellOf(vertex); } },
    rims);
  for (int round = 0; round < BorderRims::kRounds; ++round)
  {
    for (int pass = 0; pass < BorderRims::kPasses; ++pass)
    {
      exchange.update();
      if (rims != nullptr)
      {
        rims->smooth(pass);
      }
    }
    locally([&] { rims->settle(); });
  }
  locally([&] { axis->extendToCreases(); });
}

} // namespace

Extent touchingExtent(const Grid& grid, const Extent& extent)
{
  Extent touching = extent;
  for (int axis = 0; axis < 3 && !extent.empty(); ++axis)
  {
    touching.max[axis] = std::min(extent.max[axis] + 1, grid.dimensions[axis] - 1);
  }
  return touching;
}

AxisPiece computeMedialAxis(Communicator& communicator, const SurfacePiece& piece, const Grid& grid,
  const std::vector<Extent>& extents, FieldSink& sink, const MedialAxisOptions& options,
  RankCounts* counts)
{
  CountingCommunicator counting(communicator);
  RunStatistics statistics;
  std::optional<Run> run;
  std::optional<GridShare> share;
  agree(counting,
    [&]
    {
      checkOptions(options);
      checkFieldOfRanks(grid, {}, options.field);
      share.emplace(grid, extents, communicator.rank());
      run.emplace(options.field.execution);
    });
  const double angle = glm::radians(options.angle);
  const GridFrame frame(grid);
  const AxisOrder order(grid);
  const int halo = crossingHalo(frame, angle);
  const Extent part = share->withHalo(halo);
  RankField field(counting, piece, grid, part, options.field, run->part(0.0, kSelected),
    statistics);
  const bool hasSign = field.sign() != FieldSign::None;
  const Side side = hasSign ? options.side : Side::Both;
  std::vector<Crossing> crossings;
  agree(counting,
    [&]
    {
      if (!part.empty())
      {
        const Extent extent = touchingExtent(grid, share->own());
        withMemoryErrors(extent.pointCount(),
          [&] { crossings = field.select(extent, { selectionAngle(options), side }, sink); });
      }
      run->report(kSelected, "medial axis");
    });
  const Stopwatch watch(statistics.seconds.medial);
  std::optional<InsidePart> inside;
  if (hasSign)
  {
    inside.emplace(counting, field, part);
  }
  crossings = withThoseAround(counting, *share, order, field.siteNumbers(), halo, crossings);

  const Checkpoint checkpoint(*run, kSelected, "medial axis");
  const SideCheck sideCheck(
    [&]() -> SideCheck::Inside
    {
      inside->prepare();
      return [&](const glm::dvec3& x) { return inside->contains(x); };
    });
  std::optional<AxisGeometry> geometry;
  std::optional<PartAxis> axis;
  const auto locally = [&](const auto& work)
  {
    agree(counting,
      [&]
      {
        if (!part.empty())
        {
          withMemoryErrors(part.pointCount(), [&] { run->onThreads(work); });
        }
      });
  };
  locally(
    [&]
    {
      geometry.emplace(AxisGeometry{ field.sites(), field.query(), frame, grid.wholeExtent(), part,
        angle, options.lambda / frame.unit, options.radius / frame.unit, checkpoint,
        hasSign ? &sideCheck : nullptr });
      axis.emplace(*geometry, *share, order, std::move(crossings));
      axis->makePoints(options.representation);
    });
  if (options.representation == Representation::Surface)
  {
    moveRims(counting, *share, axis ? &*axis : nullptr, locally);
  }
  OwnAxis own{ options.representation == Representation::Points, {}, {} };
  locally([&] { own = axis->own(); });
  const AxisAssembly assembly(counting, *share, own, contractionHalo(frame, angle));
  BisectorPoints points;
  AxisPiece result = assembly.piece(counting, order, points);
  setAxisPoints(points, frame, result.axis);
  result.axis.sign = options.field.sign;
  result.axis.side = side;
  result.axis.statistics = statistics;
  run->report(1.0, "medial axis");
  if (counts != nullptr)
  {
    *counts = countsOf(field, counting);
  }
  return result;
}

} // namespace medial

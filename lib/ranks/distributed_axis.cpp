#include "axis/axis_attributes.h"
#include "axis/axis_geometry.h"
#include "base/checkpoint.h"
#include "base/memory_guard.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "medial/ranks.h"
#include "pipeline/axis_options.h"
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

/// Finds the sites of a part by their numbers in the whole surface.
class SitesHere
{
public:
  explicit SitesHere(const std::vector<std::int32_t>& numbers)
  {
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      sites_.emplace_back(numbers[i], static_cast<std::int32_t>(i));
    }
    std::sort(sites_.begin(), sites_.end());
  }

  /// The site must be here.
  std::int32_t find(std::int32_t number) const
  {
    return std::lower_bound(sites_.begin(), sites_.end(), std::pair(number, 0))->second;
  }

private:
  std::vector<std::pair<std::int32_t, std::int32_t>> sites_; ///< in the whole, here
};

/// Computes the axis of a rank's part, in steps that all ranks take together.
class DistributedAxis
{
public:
  /// All arguments must outlive this.
  DistributedAxis(CountingCommunicator& communicator, const SurfacePiece& piece, const Grid& grid,
    const GridShare& share, const MedialAxisOptions& options, const Run& run)
    : communicator_(communicator)
    , piece_(piece)
    , grid_(grid)
    , share_(share)
    , options_(options)
    , run_(run)
    , frame_(grid)
    , order_(grid)
    , angle_(glm::radians(options.angle))
  {
  }

  AxisPiece compute(FieldSink& sink, RankCounts* counts)
  {
    int halo = crossingHalo(frame_, angle_);
    this->bring(halo);
    const Side side = this->hasSign() ? options_.side : Side::Both;
    const std::vector<SharedCrossing> crossings =
      this->ownCrossings({ selectionAngle(options_), side }, sink);
    const Stopwatch watch(statistics_.seconds.medial);
    std::optional<OwnAxis> own;
    for (own = this->tryHalo(crossings, halo); !own; own = this->tryHalo(crossings, halo))
    {
      halo *= 2;
      this->bring(halo);
    }
    const AxisAssembly assembly(communicator_, share_, *own, contractionHalo(frame_, angle_));
    BisectorPoints points;
    AxisPiece result = assembly.piece(communicator_, order_, points);
    setAxisPoints(points, frame_, result.axis);
    result.axis.sign = field_->sharedSign().report().method;
    result.axis.side = side;
    if (counts != nullptr)
    {
      *counts = countsOf(*field_, communicator_);
    }
    return result;
  }

  const RunStatistics& statistics() const { return statistics_; }

private:
  bool hasSign() const { return field_->sign() != FieldSign::None; }

  /// Brings what can be closest in the part and a halo.
  void bring(int halo)
  {
    field_.emplace(communicator_, piece_, grid_, share_.withHalo(halo),
      touchingExtent(grid_, share_.own()), options_.field, run_.part(0.0, kSelected), statistics_);
    if (this->hasSign())
    {
      field_->closeHoles(communicator_);
    }
  }

  /// Does work of this rank on its threads; not where it has no part of the grid.
  template <typename Work>
  void locally(const Work& work) const
  {
    if (!share_.own().empty())
    {
      withMemoryErrors(share_.own().pointCount(), [&] { run_.onThreads(work); });
    }
  }

  /// Computes the field of this rank's part, and returns the crossings there.
  std::vector<SharedCrossing> ownCrossings(const CrossingSelection& selection, FieldSink& sink)
  {
    std::vector<SharedCrossing> own;
    const Extent extent = touchingExtent(grid_, share_.own());
    const auto select = [&]
    {
      const std::vector<std::int32_t> siteNumbers = field_->siteNumbers();
      for (Crossing& crossing : field_->select(extent, selection, sink))
      {
        if (share_.owns(crossing.voxel))
        {
          crossing.siteA = siteNumbers[crossing.siteA];
          crossing.siteB = siteNumbers[crossing.siteB];
          own.push_back({ crossing, order_.ofCrossing(crossing) });
        }
      }
    };
    if (!extent.empty())
    {
      withMemoryErrors(extent.pointCount(), select);
    }
    run_.report(kSelected, "medial axis");
    return own;
  }

  /// Returns the crossings of the part and its halo, in the order of one process, with the sites
  /// here.
  /// @param own those of this rank.
  std::vector<Crossing> crossingsWithin(const std::vector<SharedCrossing>& own, int halo) const
  {
    std::vector<SharedCrossing> shared = share_.spread(communicator_, own, halo,
      [](const SharedCrossing& item) { return item.crossing.voxel; });
    std::sort(shared.begin(), shared.end(),
      [](const SharedCrossing& a, const SharedCrossing& b) { return a.number < b.number; });
    const SitesHere sites(field_->siteNumbers());
    const Extent part = share_.withHalo(halo);
    std::vector<Crossing> crossings;
    for (const SharedCrossing& item : shared)
    {
      Crossing crossing = item.crossing;
      glm::ivec3 end = crossing.voxel;
      ++end[crossing.axis];
      if (GridShare::isIn(part, end))
      {
        crossing.siteA = sites.find(crossing.siteA);
        crossing.siteB = sites.find(crossing.siteB);
        crossings.push_back(crossing);
      }
    }
    return crossings;
  }

  /// Makes the points and quads of this rank from crossings in the part and a halo.
  /// @return nothing on every rank if one has seen something else than its neighbour at a rim that
  ///   goes on there: then the halo is too narrow.
  std::optional<OwnAxis> tryHalo(const std::vector<SharedCrossing>& own, int halo)
  {
    std::optional<InsidePart> inside;
    if (this->hasSign())
    {
      inside.emplace(communicator_, *field_, share_.withHalo(halo));
    }
    const SideCheck side(
      [&]() -> SideCheck::Inside
      {
        inside->prepare();
        return [&](const glm::dvec3& x) { return inside->contains(x); };
      });
    const Checkpoint checkpoint(run_, kSelected, "medial axis");
    std::vector<Crossing> crossings = this->crossingsWithin(own, halo);
    std::optional<AxisGeometry> geometry;
    std::optional<PartAxis> axis;
    this->locally(
      [&]
      {
        geometry.emplace(AxisGeometry{ field_->sites(), field_->query(), frame_, share_.whole(),
          share_.withHalo(halo), angle_, options_.lambda / frame_.unit,
          options_.radius / frame_.unit, checkpoint, inside ? &side : nullptr });
        axis.emplace(*geometry, share_, order_, std::move(crossings));
        axis->makePoints(options_.representation);
      });
    if (options_.representation == Representation::Surface &&
      !this->moveRims(axis ? &*axis : nullptr) && !this->coversGrid(halo))
    {
      return std::nullopt;
    }
    OwnAxis result{ options_.representation == Representation::Points, {}, {} };
    this->locally([&] { result = axis->own(); });
    return result;
  }

  bool coversGrid(int halo) const
  {
    const auto& last = share_.whole().max;
    return halo >= std::max({ last[0], last[1], last[2] });
  }

  /// Moves the rims of all parts to their borders, unless ranks have seen them differently.
  /// @param axis null for a rank without a part.
  bool moveRims(PartAxis* axis) const
  {
    BorderRims* const rims = axis != nullptr ? axis->rims() : nullptr;
    RimExchange exchange(communicator_, share_,
      { [&](std::size_t vertex) { return axis->numberOf(vertex); },
        [&](std::size_t vertex) { return axis->cellOf(vertex); } },
      rims);
    if (maximum(communicator_, exchange.alike() ? 0 : 1) != 0)
    {
      return false;
    }
    for (int round = 0; round < BorderRims::kRounds; ++round)
    {
      this->locally([&] { rims->beginRound(); });
      for (int pass = 0; pass < BorderRims::kPasses; ++pass)
      {
        exchange.update();
        this->locally([&] { rims->smooth(pass); });
      }
      this->locally([&] { rims->settle(); });
    }
    this->locally([&] { axis->extendToCreases(); });
    return true;
  }

  CountingCommunicator& communicator_;
  const SurfacePiece& piece_;
  const Grid& grid_;
  const GridShare& share_;
  const MedialAxisOptions& options_;
  const Run& run_;
  GridFrame frame_;
  AxisOrder order_;
  double angle_; ///< radians
  RunStatistics statistics_;
  std::optional<RankField> field_;
};

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
  AxisPiece result;
  agree(counting,
    [&]
    {
      checkOptions(options);
      checkFieldOfRanks(grid, {}, options.field);
      if (extents.size() != static_cast<std::size_t>(communicator.size()))
      {
        throw Error(ErrorCode::InvalidInput,
          std::to_string(extents.size()) + " extents for " + std::to_string(communicator.size()) +
            " ranks; there must be one for each");
      }
      const GridShare share(grid, extents, communicator.rank());
      const Run run(options.field.execution);
      DistributedAxis axis(counting, piece, grid, share, options, run);
      result = axis.compute(sink, counts);
      result.axis.statistics = axis.statistics();
      run.report(1.0, "medial axis");
    });
  return result;
}

} // namespace medial

#include "ranks/distributed_axis.h"

#include "axis/axis_attributes.h"
#include "axis/axis_geometry.h"
#include "base/checkpoint.h"
#include "base/memory_guard.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "culling/extent_parts.h"
#include "medial/ranks.h"
#include "pipeline/axis_options.h"
#include "ranks/axis_assembly.h"
#include "ranks/collective.h"
#include "ranks/counting_communicator.h"
#include "ranks/inside_part.h"
#include "ranks/part_axis.h"
#include "ranks/rank_field.h"
#include "ranks/rim_exchange.h"
#include "ranks/whole_piece.h"
#include "ranks/work_cut.h"

#include <algorithm>
#include <map>
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

/// Crossings are counted in boxes of at least so many grid points along an edge, where so many
/// boxes suffice for a part.
constexpr int kMinBox = 4;
constexpr std::int64_t kEnoughBoxes = 4096;

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

/// Returns the boxes of a grid that have crossings, and how many.
std::vector<WorkBox> crossingsInBoxes(const std::vector<SharedCrossing>& crossings, int size,
  const Extent& whole)
{
  std::map<std::array<int, 3>, std::int64_t> counts; // by the first point
  for (const SharedCrossing& item : crossings)
  {
    const glm::ivec3& voxel = item.crossing.voxel;
    ++counts[{ voxel.x - voxel.x % size, voxel.y - voxel.y % size, voxel.z - voxel.z % size }];
  }
  std::vector<WorkBox> boxes;
  for (const auto& [first, count] : counts)
  {
    boxes.push_back({ wholeParts({ first, first }, size, whole), static_cast<double>(count) });
  }
  return boxes;
}

/// Computes the axis of a rank's part, in steps that all ranks take together.
class DistributedAxis
{
public:
  /// All arguments must outlive this.
  DistributedAxis(CountingCommunicator& communicator, const SurfacePiece& piece, const Grid& grid,
    const MedialAxisOptions& options, const Run& run)
    : communicator_(communicator)
    , grid_(grid)
    , options_(options)
    , run_(run)
    , frame_(grid)
    , order_(grid)
    , angle_(glm::radians(options.angle))
    , field_(communicator, piece, grid, options.field, run.part(0.0, kSelected), statistics_)
  {
  }

  /// @param fieldShare where ranks compute the field and find crossings.
  /// @param axisExtents see computeMedialAxis().
  AxisPiece compute(const GridShare& fieldShare, const std::vector<Extent>& axisExtents,
    FieldSink& sink, RankCounts* counts)
  {
    int halo = crossingHalo(frame_, angle_);
    const Side side = this->hasSign() ? options_.side : Side::Both;
    std::vector<SharedCrossing> crossings =
      this->crossingsOf(fieldShare, { selectionAngle(options_), side }, sink);
    const Stopwatch watch(statistics_.seconds.medial);
    share_.emplace(grid_, axisExtents.empty() ? this->partsOfAxis(crossings, halo) : axisExtents,
      communicator_.rank());
    crossings = share_->toOwners(communicator_, crossings,
      [](const SharedCrossing& item) { return item.crossing.voxel; });
    this->bring(halo);
    std::optional<OwnAxis> own;
    for (own = this->tryHalo(crossings, halo); !own; own = this->tryHalo(crossings, halo))
    {
      halo *= 2;
      this->bring(halo);
    }
    const AxisAssembly assembly(communicator_, *share_, *own, contractionHalo(frame_, angle_));
    BisectorPoints points;
    AxisPiece result = assembly.piece(communicator_, order_, points);
    setAxisPoints(points, frame_, result.axis);
    result.axis.sign = field_.sharedSign().report().method;
    result.axis.side = side;
    if (counts != nullptr)
    {
      *counts = countsOf(field_, communicator_);
      counts->crossings = crossingsSeen_;
    }
    return result;
  }

  const RunStatistics& statistics() const { return statistics_; }

private:
  bool hasSign() const { return field_.sign() != FieldSign::None; }

  /// Brings what can be closest in the part of the axis and a halo.
  void bring(int halo)
  {
    field_.bring(communicator_, share_->withHalo(halo), {});
    if (this->hasSign())
    {
      field_.closeHoles(communicator_);
    }
  }

  /// Cuts the grid so that ranks have about as many crossings in their parts and halos.
  std::vector<Extent> partsOfAxis(const std::vector<SharedCrossing>& crossings, int halo) const
  {
    const int size = workBoxSize(grid_, communicator_.size(), kMinBox, kEnoughBoxes);
    return partsOfWork(communicator_, grid_, WorkCut(size, halo),
      crossingsInBoxes(crossings, size, grid_.wholeExtent()));
  }

  /// Does work of this rank on its threads; not where it has no part of the grid.
  template <typename Work>
  void locally(const Work& work) const
  {
    if (!share_->own().empty())
    {
      withMemoryErrors(share_->own().pointCount(), [&] { run_.onThreads(work); });
    }
  }

  /// Computes the field of this rank's part, and returns the crossings there.
  std::vector<SharedCrossing> crossingsOf(const GridShare& fieldShare,
    const CrossingSelection& selection, FieldSink& sink)
  {
    std::vector<SharedCrossing> own;
    const Extent extent = touchingExtent(grid_, fieldShare.own());
    field_.bring(communicator_, extent, extent);
    const auto select = [&]
    {
      const std::vector<std::int32_t> siteNumbers = field_.siteNumbers();
      for (Crossing& crossing : field_.select(extent, selection, sink))
      {
        if (fieldShare.owns(crossing.voxel))
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
    std::vector<SharedCrossing> shared = share_->spread(communicator_, own, halo,
      [](const SharedCrossing& item) { return item.crossing.voxel; });
    std::sort(shared.begin(), shared.end(),
      [](const SharedCrossing& a, const SharedCrossing& b) { return a.number < b.number; });
    const SitesHere sites(field_.siteNumbers());
    const Extent part = share_->withHalo(halo);
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
      inside.emplace(communicator_, field_, share_->withHalo(halo));
    }
    const SideCheck side(
      [&]() -> SideCheck::Inside
      {
        inside->prepare();
        return [&](const glm::dvec3& x) { return inside->contains(x); };
      });
    const Checkpoint checkpoint(run_, kSelected, "medial axis");
    std::vector<Crossing> crossings = this->crossingsWithin(own, halo);
    crossingsSeen_ = static_cast<std::int64_t>(crossings.size());
    std::optional<AxisGeometry> geometry;
    std::optional<PartAxis> axis;
    this->locally(
      [&]
      {
        geometry.emplace(AxisGeometry{ field_.sites(), field_.query(), frame_, share_->whole(),
          share_->withHalo(halo), angle_, options_.lambda / frame_.unit,
          options_.radius / frame_.unit, checkpoint, inside ? &side : nullptr });
        axis.emplace(*geometry, *share_, order_, std::move(crossings));
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
    const auto& last = share_->whole().max;
    return halo >= std::max({ last[0], last[1], last[2] });
  }

  /// Moves the rims of all parts to their borders, unless ranks have seen them differently.
  /// @param axis null for a rank without a part.
  bool moveRims(PartAxis* axis) const
  {
    BorderRims* const rims = axis != nullptr ? axis->rims() : nullptr;
    RimExchange exchange(communicator_, *share_,
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
  const Grid& grid_;
  const MedialAxisOptions& options_;
  const Run& run_;
  GridFrame frame_;
  AxisOrder order_;
  double angle_; ///< radians
  RunStatistics statistics_;
  RankField field_;
  std::optional<GridShare> share_; ///< where ranks make the axis
  std::int64_t crossingsSeen_ = 0; ///< in the part of the axis and its halo
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
  return computeMedialAxis(communicator, piece, grid, extents, {}, sink, options, counts);
}

AxisPiece computeMedialAxis(Communicator& communicator, const SurfacePiece& piece, const Grid& grid,
  const std::vector<Extent>& extents, const std::vector<Extent>& axisExtents, FieldSink& sink,
  const MedialAxisOptions& options, RankCounts* counts)
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
      const std::optional<WholePiece> whole =
        communicator.size() == 1 ? wholePiece(piece) : std::nullopt;
      if (whole)
      {
        MedialAxisOptions wanted = options;
        wanted.field.engine = Engine::Processor;
        result = onlyPiece(computeMedialAxis(whole->mesh,
          analyseConnectivity(whole->mesh, options.field.execution), grid, wanted, sink));
        setCounts(whole->mesh, counting, counts);
        return;
      }
      const Run run(options.field.execution);
      DistributedAxis axis(counting, piece, grid, options, run);
      result = axis.compute(share, axisExtents, sink, counts);
      result.axis.statistics = axis.statistics();
      run.report(1.0, "medial axis");
    });
  return result;
}

} // namespace medial

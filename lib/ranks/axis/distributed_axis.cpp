#include "ranks/axis/distributed_axis.h"

#include "axis/axis_attributes.h"
#include "axis/axis_geometry.h"
#include "base/checkpoint.h"
#include "base/extents.h"
#include "base/memory_guard.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "field/field_tap.h"
#include "medial/ranks.h"
#include "pipeline/axis_options.h"
#include "ranks/axis/axis_assembly.h"
#include "ranks/axis/part_axis.h"
#include "ranks/axis/preserved_pieces.h"
#include "ranks/axis/rank_part.h"
#include "ranks/axis/sites_here.h"
#include "ranks/collective.h"
#include "ranks/counting_communicator.h"
#include "ranks/field/field_part.h"
#include "ranks/field/inside_part.h"
#include "ranks/field/rank_field.h"
#include "ranks/field/work_cut.h"
#include "ranks/whole_piece.h"
#include "simplification/simplify_axis.h"

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

/// Crossings are counted in boxes of at least so many grid points along an edge, where so many
/// boxes suffice for a part.
constexpr int kMinBox = 4;
constexpr std::int64_t kEnoughBoxes = 4096;

/// Where the progress is when ranks have their pieces, if the first then simplifies the whole.
constexpr double kInPieces = 0.9;

/// A crossing with the numbers that its sites have in the whole surface.
struct SharedCrossing
{
  Crossing crossing;
  std::int64_t number; ///< as AxisOrder
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
    , limits_(limitsOf(options, frame_))
    , field_(communicator, piece, grid, options.field, run.part(0.0, kSelectedShare), statistics_)
  {
  }

  /// @param fieldShare where ranks compute the field and find crossings.
  /// @param axisExtents see computeMedialAxis().
  AxisPiece compute(const GridShare& fieldShare, const std::vector<Extent>& axisExtents,
    FieldSink& sink, RankCounts* counts)
  {
    int halo = crossingHalo(frame_, limits_.angle);
    const Side side = sideOf(options_.side, this->hasSign());
    const bool preserve = options_.topology == Topology::Preserve;
    FieldPart values;
    std::vector<SharedCrossing> crossings = this->crossingsOf(fieldShare,
      { selectionAngle(options_), side }, sink, preserve ? &values : nullptr);
    const Stopwatch watch(statistics_.seconds.medial);
    const std::vector<Extent> extents =
      axisExtents.empty() ? this->partsOfAxis(crossings, halo) : axisExtents;
    share_.emplace(grid_, extents, communicator_.rank());
    part_.emplace(*share_, field_, run_);
    crossings = share_->toOwners(communicator_, crossings,
      [](const SharedCrossing& item) { return item.crossing.voxel; });
    BisectorPoints points;
    AxisPiece result = preserve ? this->preserved(crossings, RankPart(fieldShare, field_, run_),
                                    std::move(values), halo, points)
                                : this->selected(crossings, halo, points);
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
  bool hasSign() const { return field_.hasSign(); }

  /// Cuts the grid so that ranks have about as many crossings in their parts and halos.
  std::vector<Extent> partsOfAxis(const std::vector<SharedCrossing>& crossings, int halo) const
  {
    const int size = workBoxSize(grid_, communicator_.size(), kMinBox, kEnoughBoxes);
    return partsOfWork(communicator_, grid_, WorkCut(size, halo),
      crossingsInBoxes(crossings, size, grid_.wholeExtent()));
  }

  /// Computes the field of this rank's part, and returns the crossings there.
  /// @param values receives the field for thinning; may be null.
  std::vector<SharedCrossing> crossingsOf(const GridShare& fieldShare, CrossingSelection selection,
    FieldSink& sink, FieldPart* values)
  {
    std::vector<SharedCrossing> own;
    const Extent extent = touchingExtent(grid_, fieldShare.own());
    // What is next to points of the side must be known as well.
    field_.bring(communicator_, extent,
      values != nullptr ? grown(extent, FieldTap::kMargin, grid_.wholeExtent()) : extent);
    std::optional<FieldTap> tap;
    if (values != nullptr)
    {
      tap.emplace(sink, extent, selection.side);
      selection.tap = &*tap;
    }
    const auto select = [&]
    {
      const std::vector<std::int32_t> siteNumbers = field_.siteNumbers();
      for (Crossing& crossing : field_.select(extent, selection, tap ? *tap : sink))
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
    if (values != nullptr)
    {
      *values = { extent, { tap->distances().begin(), tap->distances().end() },
        { tap->sites().begin(), tap->sites().end() } };
    }
    run_.report(kSelectedShare, "medial axis");
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
      if (hasPoint(part, end))
      {
        crossing.siteA = sites.find(crossing.siteA);
        crossing.siteB = sites.find(crossing.siteB);
        crossings.push_back(crossing);
      }
    }
    return crossings;
  }

  /// Calls make(geometry of the part and a halo, crossings there); the geometry is null for a rank
  /// without a part.
  template <typename Make>
  auto withHalo(const std::vector<SharedCrossing>& own, int halo, const Checkpoint& checkpoint,
    const Make& make)
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
    std::vector<Crossing> crossings = this->crossingsWithin(own, halo);
    crossingsSeen_ = static_cast<std::int64_t>(crossings.size());
    std::optional<AxisGeometry> geometry;
    part_->locally(
      [&]
      {
        geometry.emplace(AxisGeometry{ field_.sites(), field_.query(), frame_, share_->whole(),
          share_->withHalo(halo), limits_, checkpoint, inside ? &side : nullptr });
      });
    return make(geometry ? &*geometry : nullptr, std::move(crossings));
  }

  /// Makes the points and quads of this rank from crossings in the part and a halo.
  /// @return nothing on every rank if one has seen something else than its neighbour at a rim that
  ///   goes on there: then the halo is too narrow.
  std::optional<OwnAxis> tryHalo(const std::vector<SharedCrossing>& own, int halo)
  {
    const Checkpoint checkpoint(run_, kSelectedShare, "medial axis");
    return this->withHalo(own, halo, checkpoint,
      [&](const AxisGeometry* geometry, std::vector<Crossing> crossings) -> std::optional<OwnAxis>
      {
        std::optional<PartAxis> axis;
        part_->locally(
          [&]
          {
            axis.emplace(*geometry, *share_, order_, std::move(crossings));
            axis->makePoints(options_.representation);
          });
        if (options_.representation == Representation::Surface &&
          !this->moveRims(axis ? &*axis : nullptr) && !part_->coversGrid(halo))
        {
          return std::nullopt;
        }
        OwnAxis result{ options_.representation == Representation::Points, {}, {} };
        part_->locally([&] { result = axis->own(); });
        return result;
      });
  }

  /// @param crossings those of this rank.
  AxisPiece selected(const std::vector<SharedCrossing>& crossings, int halo, BisectorPoints& points)
  {
    part_->bring(communicator_, halo);
    std::optional<OwnAxis> own;
    for (own = this->tryHalo(crossings, halo); !own; own = this->tryHalo(crossings, halo))
    {
      halo *= 2;
      part_->bring(communicator_, halo);
    }
    const AxisAssembly assembly(communicator_, *share_, *own,
      contractionHalo(frame_, limits_.angle));
    return assembly.piece(communicator_, order_, points);
  }

  /// The same with the topology of the solid.
  /// @param fieldPart where this rank has computed the field.
  /// @param values there.
  AxisPiece preserved(const std::vector<SharedCrossing>& crossings, const RankPart& fieldPart,
    FieldPart values, int halo, BisectorPoints& points)
  {
    const Side side = sideOf(options_.side, this->hasSign());
    PreservedPieces pieces({ communicator_, *part_, grid_, options_, side }, fieldPart,
      std::move(values));
    const Checkpoint checkpoint(run_, kSelectedShare, "medial axis");
    const auto tryHalo = [&]
    {
      part_->bring(communicator_, halo);
      return this->withHalo(crossings, halo, checkpoint,
        [&](const AxisGeometry* geometry, std::vector<Crossing> around)
        { return pieces.tryHalo(geometry, std::move(around), halo, checkpoint); });
    };
    while (!tryHalo())
    {
      halo *= 2;
    }
    pieces.finishCurves(checkpoint);
    return pieces.piece(points);
  }

  /// Moves the rims of all parts to their borders, unless ranks have seen them differently.
  /// @param axis null for a rank without a part.
  bool moveRims(PartAxis* axis) const
  {
    const RimExchange::Vertices vertices{ [&](std::size_t vertex)
      { return axis->numberOf(vertex); },
      [&](std::size_t vertex) { return axis->cellOf(vertex); } };
    if (!part_->moveRims(communicator_, vertices, axis != nullptr ? axis->rims() : nullptr))
    {
      return false;
    }
    part_->locally([&] { axis->extendToCreases(); });
    return true;
  }

  CountingCommunicator& communicator_;
  const Grid& grid_;
  const MedialAxisOptions& options_;
  const Run& run_;
  GridFrame frame_;
  AxisOrder order_;
  AxisLimits limits_;
  RunStatistics statistics_;
  RankField field_;
  std::optional<GridShare> share_; ///< where ranks make the axis
  std::optional<RankPart> part_;   ///< that of this rank
  std::int64_t crossingsSeen_ = 0; ///< in the part of the axis and its halo
};

/// Brings an axis together on the first rank, which makes it compact.
AxisPiece simplified(Communicator& communicator, const AxisPiece& piece, std::int64_t maxSpheres,
  const Run& run)
{
  MedialAxis whole = gatherMedialAxis(communicator, piece);
  AxisPiece result;
  agree(communicator,
    [&]
    {
      if (communicator.rank() == 0)
      {
        whole = simplifyAxis(whole, maxSpheres, run);
      }
      result = onlyPiece(std::move(whole));
      result.points = gathered(communicator, result.points).front();
      result.cells = gathered(communicator, result.cells).front();
    });
  return result;
}

} // namespace

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
      checkAxisOptions(options);
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
      const bool simplifies = options.maxSpheres > 0;
      const Run inPieces = run.part(0.0, simplifies ? kInPieces : 1.0);
      DistributedAxis axis(counting, piece, grid, options, inPieces);
      result = axis.compute(share, axisExtents, sink, counts);
      result.axis.statistics = axis.statistics();
      if (simplifies)
      {
        result = simplified(counting, result, options.maxSpheres, run.part(kInPieces, 1.0));
      }
      run.report(1.0, "medial axis");
    });
  return result;
}

} // namespace medial

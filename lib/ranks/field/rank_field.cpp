#include "ranks/field/rank_field.h"

#include "base/extents.h"
#include "base/stopwatch.h"
#include "culling/extent_hull.h"
#include "field/array_sink.h"
#include "field/engines/processor/processor_engine.h"
#include "field/precision_checks.h"
#include "field/tile_field.h"
#include "medial/error.h"
#include "ranks/collective.h"

#include <algorithm>
#include <string>
#include <utility>

namespace medial
{
namespace
{

/// Grid points along an edge of the boxes that are searched for: those of a set of tiles.
constexpr int kBoxSize = 16;

/// Gives sites the numbers that they have in the whole surface.
class NumberingSink : public FieldSink
{
public:
  /// @param field must outlive this.
  NumberingSink(FieldSink& sink, const RankField& field)
    : sink_(sink)
    , field_(field)
  {
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    arrays_ = sink_.slabArrays(slab);
    return arrays_;
  }

  void stored(const Extent& slab) override
  {
    if (arrays_.closestSite != nullptr)
    {
      if (numbers_.empty())
      {
        numbers_ = field_.siteNumbers();
      }
      std::transform(arrays_.closestSite, arrays_.closestSite + slab.pointCount(),
        arrays_.closestSite, [this](std::int32_t site) { return numbers_[site]; });
    }
    sink_.stored(slab);
  }

  std::size_t bytesPerPoint() const override { return sink_.bytesPerPoint(); }

private:
  FieldSink& sink_;
  const RankField& field_;
  std::vector<std::int32_t> numbers_; ///< of the part's sites, once they are needed
  FieldArrays arrays_;
};

std::vector<FrameBox> boxesOf(const Grid& grid, const GridFrame& frame, const Extent& extent)
{
  std::vector<FrameBox> boxes;
  if (!extent.empty())
  {
    visitParts(wholeParts(extent, kBoxSize, grid.wholeExtent()), kBoxSize,
      [&](const Extent& box) { boxes.push_back(hullOf(box, frame)); });
  }
  return boxes;
}

/// Returns an extent from where tiles begin along x: engines select there.
Extent fromTile(Extent extent)
{
  extent.min[0] -= extent.min[0] % TileField::kRow;
  return extent;
}

} // namespace

void checkFieldOfRanks(const Grid& grid, const Extent& extent, const DistanceFieldOptions& options)
{
  validateGrid(grid);
  if (!extent.empty() && !grid.wholeExtent().contains(extent))
  {
    throw Error(ErrorCode::InvalidInput, "the extent leaves the grid");
  }
  if (options.engine != Engine::Auto && options.engine != Engine::Processor)
  {
    throw Error(ErrorCode::InvalidInput,
      "the field of a surface in pieces needs the engine processor");
  }
}

RankCounts countsOf(const RankField& field, const CountingCommunicator& communicator)
{
  return { field.ownTriangles(), field.heldTriangles(), communicator.bytesSent(),
    communicator.exchanges() };
}

RankField::RankField(Communicator& communicator, const SurfacePiece& piece, const Grid& grid,
  const DistanceFieldOptions& options, const Run& run, RunStatistics& statistics)
  : grid_(grid)
  , whole_(grid.wholeExtent())
  , memoryMiB_(options.memoryMiB)
  , run_(run)
  , statistics_(statistics)
  , surface_(communicator, piece)
  , frame_(grid)
  , sign_(timed(statistics.seconds.sign,
      [&] { return SharedSign(communicator, surface_, options.sign, grid, frame_, run_); }))
  , ownTriangles_(static_cast<std::int64_t>(surface_.faces().size()))
{
  requireSinglePrecision(surface_.bounds(), frame_);
  {
    const Stopwatch watch(statistics_.seconds.cull);
    tree_.emplace(communicator, surface_, frame_);
  }
  statistics_.engine = Engine::Processor;
  statistics_.sign = sign_.report();
  statistics_.sites =
    static_cast<std::int64_t>(surface_.faceCount()) + surface_.edgeCount() + surface_.pointCount();
}

void RankField::bring(Communicator& communicator, const Extent& searched, const Extent& computed)
{
  this->bring(communicator, boxesOf(grid_, frame_, searched), computed);
}

void RankField::bring(Communicator& communicator, const std::vector<FrameBox>& boxes,
  const Extent& computed)
{
  // What was here goes first: both together are more than a rank may hold.
  host_.reset();
  near_.reset();
  inside_.reset();
  if (sign_.fieldSign() == FieldSign::Rows)
  {
    const Stopwatch watch(statistics_.seconds.sign);
    inside_.emplace(sign_.insideRows(communicator, fromTile(computed)));
  }
  {
    const Stopwatch watch(statistics_.seconds.cull);
    near_.emplace(tree_->near(communicator, boxes));
  }
  heldTriangles_ = std::max(heldTriangles_, static_cast<std::int64_t>(near_->part.faces().size()));
  host_.emplace(near_->part.mesh(), near_->part.connectivity(), frame_, this->sign(), run_,
    statistics_,
    [this](const SiteSet& sites)
    {
      const std::vector<SparseTree> trees = std::move(near_->trees); // they are needed once
      return GroupTree(sites, near_->part.connectivity(), near_->slack, trees);
    });
}

void RankField::settle()
{
  tree_.reset();
  surface_.dropFaces();
  static_cast<void>(host_->sites()); // from here on they stand for the part's geometry
  near_->part.dropGeometry();
}

FieldJob RankField::job(const Extent& extent)
{
  statistics_.samples = extent.pointCount();
  return { near_->part.mesh(), near_->part.connectivity(), *host_, this->sign(),
    inside_ ? &*inside_ : nullptr, frame_, whole_, extent, memoryMiB_, false, run_, statistics_ };
}

void RankField::compute(const Extent& extent, FieldSink& sink)
{
  NumberingSink numbering(sink, *this);
  ProcessorEngine().run(this->job(extent), numbering);
}

std::int64_t RankField::tryWork(const Extent& extent)
{
  const auto work = [this]
  { return statistics_.groupTests + statistics_.candidatePairs + statistics_.fragments; };
  const std::int64_t before = work();
  std::vector<float> distances(static_cast<std::size_t>(extent.pointCount()));
  FieldArrays arrays;
  arrays.distance = distances.data();
  ArraySink sink(extent, arrays);
  ProcessorEngine().run(this->job(extent), sink);
  return work() - before;
}

std::vector<Crossing> RankField::select(const Extent& extent, const CrossingSelection& selection,
  FieldSink& sink)
{
  // Where it begins elsewhere the field comes first, by itself.
  const Extent selected = fromTile(extent);
  if (selected.min[0] != extent.min[0])
  {
    this->compute(extent, sink);
    ArraySink nothing(selected, {});
    return ProcessorEngine().select(this->job(selected), { selection.angle, selection.side },
      nothing);
  }
  NumberingSink numbering(sink, *this);
  return ProcessorEngine().select(this->job(extent), selection, numbering);
}

} // namespace medial

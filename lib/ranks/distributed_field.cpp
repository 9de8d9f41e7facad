#include "base/memory_guard.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "culling/extent_parts.h"
#include "field/engines/processor/processor_engine.h"
#include "field/field_job.h"
#include "field/reach.h"
#include "medial/ranks.h"
#include "ranks/collective.h"
#include "ranks/counting_communicator.h"
#include "ranks/shared_tree.h"

#include <algorithm>
#include <optional>
#include <string>

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
  /// @param numbers of the sites of a part.
  NumberingSink(FieldSink& sink, std::vector<std::int32_t> numbers)
    : sink_(sink)
    , numbers_(std::move(numbers))
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
      std::transform(arrays_.closestSite, arrays_.closestSite + slab.pointCount(),
        arrays_.closestSite, [this](std::int32_t site) { return numbers_[site]; });
    }
    sink_.stored(slab);
  }

  std::size_t bytesPerPoint() const override { return sink_.bytesPerPoint(); }

private:
  FieldSink& sink_;
  std::vector<std::int32_t> numbers_;
  FieldArrays arrays_;
};

void checkOptions(const Grid& grid, const Extent& extent, const DistanceFieldOptions& options)
{
  validateGrid(grid);
  if (!extent.empty() && !grid.wholeExtent().contains(extent))
  {
    throw Error(ErrorCode::InvalidInput, "the extent leaves the grid");
  }
  if (options.sign == SignMethod::Auto || options.sign == SignMethod::Winding)
  {
    throw Error(ErrorCode::InvalidInput,
      std::string("sign method ") + (options.sign == SignMethod::Auto ? "auto" : "winding") +
        " needs the whole surface in one process; a surface in pieces allows none and "
        "pseudonormal");
  }
  if (options.engine != Engine::Auto && options.engine != Engine::Processor)
  {
    throw Error(ErrorCode::InvalidInput,
      "the field of a surface in pieces needs the engine processor");
  }
}

FieldSign signOf(const DistributedSurface& surface, SignMethod method)
{
  if (method == SignMethod::None)
  {
    return FieldSign::None;
  }
  if (surface.boundaryEdges() > 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "sign method pseudonormal needs a closed, consistently oriented mesh; this one has " +
        std::to_string(surface.boundaryEdges()) + " boundary edges; use none");
  }
  return surface.signedVolume() < 0.0 ? FieldSign::Inward : FieldSign::Outward;
}

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

/// Computes this rank's part.
void computePart(const NearSurface& near, const DistributedSurface& surface, FieldSign sign,
  const GridFrame& frame, const Grid& grid, const Extent& extent, FieldSink& sink,
  const DistanceFieldOptions& options, const Run& run, RunStatistics& statistics)
{
  const HostSites host(near.part.mesh(), near.part.connectivity(), frame, sign, run, statistics,
    [&](const SiteSet& sites)
    { return GroupTree(sites, near.part.connectivity(), near.slack, near.trees); });
  statistics.engine = Engine::Processor;
  statistics.samples = extent.pointCount();
  NumberingSink numbering(sink, near.part.siteNumbers(surface));
  ProcessorEngine().run({ near.part.mesh(), near.part.connectivity(), host, sign, nullptr, frame,
                          grid.wholeExtent(), extent, options.memoryMiB, false, run, statistics },
    numbering);
}

} // namespace

RunStatistics computeDistanceField(Communicator& communicator, const SurfacePiece& piece,
  const Grid& grid, const Extent& extent, FieldSink& sink, const DistanceFieldOptions& options,
  RankCounts* counts)
{
  CountingCommunicator counting(communicator);
  RunStatistics statistics;
  std::optional<Run> run;
  agree(counting,
    [&]
    {
      checkOptions(grid, extent, options);
      run.emplace(options.execution);
    });
  const DistributedSurface surface(counting, piece);
  const GridFrame frame(grid);
  checkReach(surface.bounds(), frame);
  const FieldSign sign = signOf(surface, options.sign);
  statistics.sign.method = options.sign;
  statistics.sites =
    static_cast<std::int64_t>(surface.faceCount()) + surface.edgeCount() + surface.pointCount();
  std::optional<NearSurface> near;
  {
    const Stopwatch watch(statistics.seconds.cull);
    const SharedTree tree(counting, surface, frame);
    near.emplace(tree.near(counting, boxesOf(grid, frame, extent)));
  }
  agree(counting,
    [&]
    {
      if (!extent.empty())
      {
        withMemoryErrors(extent.pointCount(),
          [&] {
            computePart(*near, surface, sign, frame, grid, extent, sink, options, *run, statistics);
          });
      }
      run->report(1.0, "distance field");
    });
  if (counts != nullptr)
  {
    *counts = { static_cast<std::int64_t>(surface.faces().size()),
      static_cast<std::int64_t>(near->part.faces().size()), counting.bytesSent() };
  }
  return statistics;
}

} // namespace medial

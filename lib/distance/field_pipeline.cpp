#include "medial/distance/field_pipeline.h"

#include "medial/common/error.h"
#include "medial/common/stopwatch.h"
#include "medial/distance/hole_repair.h"
#include "medial/sites/pseudonormals.h"

#include "medial/distance/tile_evaluator.h"
#include <tbb/enumerable_thread_specific.h>
#include <cstdlib>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string>

namespace medial
{
namespace
{

constexpr std::size_t kDefaultMemoryMiB = 512;
constexpr int kSlabSlices = 64;
/// What a grid point of a slab costs in textures, their copies on the host and polygons.
constexpr std::size_t kBytesPerPoint = 96;

FieldSign fieldSign(SignMethod sign, const MeshTopology& topology)
{
  if (sign != SignMethod::Pseudonormal)
  {
    return FieldSign::None;
  }
  return topology.signedVolume < 0.0 ? FieldSign::Inward : FieldSign::Outward;
}

SignMethod checkedSign(const TriangleMesh& mesh, const MeshTopology& topology, const Grid& grid,
  const Extent& extent, const DistanceFieldOptions& options)
{
  if (mesh.empty())
  {
    throw Error(ErrorCode::InvalidInput, "the mesh has no cells");
  }
  validateGrid(grid);
  if (extent.empty() || !grid.wholeExtent().contains(extent))
  {
    throw Error(ErrorCode::InvalidInput, "the extent is empty or leaves the grid");
  }
  if (options.threads < 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "threads " + std::to_string(options.threads) + " is negative");
  }
  return resolveSignMethod(options.sign, topology);
}

Device checkedDevice(const DistanceFieldOptions& options)
{
  Device device = queryDevice();
  if (options.requireHardware && device.software)
  {
    throw Error(ErrorCode::NoGpu,
      "a hardware renderer is required, but OpenGL runs on " + device.renderer);
  }
  return device;
}

RunStatistics newStatistics(const Extent& extent, const DistanceFieldOptions& options)
{
  RunStatistics statistics;
  statistics.device = checkedDevice(options);
  statistics.samples = extent.pointCount();
  return statistics;
}

int textureLimit()
{
  GLint limit = 0;
  gpu::GpuThread::instance().run([&] { glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit); });
  return limit;
}

} // namespace

FieldPipeline::FieldPipeline(const TriangleMesh& mesh, const MeshTopology& topology,
  const Grid& grid, const Extent& extent, const DistanceFieldOptions& options)
  : mesh_(mesh)
  , topology_(topology)
  , extent_(extent)
  , options_(options)
  , frame_(grid)
  , sign_(checkedSign(mesh, topology, grid, extent, options))
  , statistics_(newStatistics(extent, options))
  , sites_(timed(statistics_.seconds.sites, [&] { return SiteSet(mesh, topology, frame_); }))
  , filter_(timed(statistics_.seconds.cull, [&] { return CandidateFilter(sites_); }))
  , normals_(timed(statistics_.seconds.sites,
      [&] { return pseudonormals(sites_, fieldSign(sign_, topology) == FieldSign::Inward); }))
{
  statistics_.sites = sites_.size();
}

void FieldPipeline::inArena(const std::function<void()>& work) const
{
  // TBB complains when it is asked for more threads than there are cores.
  const int cores = tbb::info::default_concurrency();
  tbb::task_arena arena(options_.threads > 0 ? std::min(options_.threads, cores) : cores);
  arena.execute(work);
}

void FieldPipeline::report(double fraction, const char* phase) const
{
  if (options_.progress == nullptr)
  {
    return;
  }
  options_.progress->report(fraction, phase);
  if (options_.progress->cancelled())
  {
    throw Error(ErrorCode::Cancelled, "cancelled");
  }
}

AtlasLayout FieldPipeline::chooseAtlas() const
{
  const std::size_t mebibytes = options_.memoryMiB > 0 ? options_.memoryMiB : kDefaultMemoryMiB;
  const std::size_t slice = kBytesPerPoint * static_cast<std::size_t>(extent_.size(0)) *
    static_cast<std::size_t>(extent_.size(1));
  const std::size_t fitting = mebibytes * 1024 * 1024 / slice;
  const int limit = textureLimit();
  int slices = kSlabSlices;
  while (slices > 1 &&
    (static_cast<std::size_t>(slices) > fitting || !AtlasLayout::fits(extent_, slices, limit)))
  {
    slices /= 2;
  }
  return AtlasLayout::make(extent_, slices, limit);
}

void FieldPipeline::run(const FieldArrays& arrays, SlabStage* stage)
{
  if (stage == nullptr && std::getenv("RASTER") == nullptr) { this->evaluateTiles(arrays, stage); return; }
  this->rasterise(arrays, stage);
}

void FieldPipeline::evaluateTiles(const FieldArrays& arrays, SlabStage*)
{
  const CandidateHierarchy hierarchy = this->cullBlocks(64, TileHull::Points);
  const FieldWriter writer(mesh_, topology_, sites_, frame_, extent_, arrays, sign_ != SignMethod::None);
  std::unique_ptr<TileEvaluator> evaluator;
  timed(statistics_.seconds.sites, [&] { evaluator = std::make_unique<TileEvaluator>(sites_, normals_, frame_, filter_.slack()); });
  struct Work { TileField field; double seconds = 0; std::int64_t pairs = 0; std::int64_t fragments = 0; };
  tbb::enumerable_thread_specific<Work> works;
  double wall = 0;
  this->inArena([&] { timed(wall, [&] {
    hierarchy.visitLeaves(extent_, [&](const Extent& tile, const std::vector<int>& candidates)
    {
      Work& work = works.local();
      const Stopwatch watch(work.seconds);
      work.pairs += (std::int64_t)candidates.size();
      work.fragments += evaluator->evaluate(tile, candidates, work.field);
      writer.store(tile, work.field);
    }); }); });
  double seconds = 0;
  for (const Work& w : works) { seconds += w.seconds; statistics_.candidatePairs += w.pairs; statistics_.fragments += w.fragments; }
  seconds /= 2;
  statistics_.seconds.draw += seconds;
  statistics_.seconds.cull += wall - seconds;
}

void FieldPipeline::rasterise(const FieldArrays& arrays, SlabStage* stage)
{
  this->report(0.0, "distance field");
  const AtlasLayout atlas = this->chooseAtlas();
  const CandidateHierarchy hierarchy = this->cullBlocks(atlas.slabSlices,
    stage != nullptr ? TileHull::Cells : TileHull::Points);
  const int slabCount = (extent_.size(2) + atlas.slabSlices - 1) / atlas.slabSlices;
  if (stage != nullptr)
  {
    query_ = std::make_unique<TileQuery>(sites_, filter_, frame_, extent_, hierarchy.leafSize());
  }
  gpu::OnGpuThread<SlabRenderer> renderer(sites_, normals_, frame_, atlas,
    fieldSign(sign_, topology_));
  FieldWriter writer(mesh_, topology_, sites_, frame_, extent_, arrays, sign_ != SignMethod::None);
  // A stage has work left after the last slab.
  const double perSlab = (stage != nullptr ? 0.8 : 1.0) / slabCount;
  int previousSlices = 0;
  for (int slab = 0; slab < slabCount; ++slab)
  {
    this->report(slab * perSlab, "distance field");
    Extent extent = extent_;
    extent.min[2] += slab * atlas.slabSlices;
    extent.max[2] = std::min(extent.min[2] + atlas.slabSlices - 1, extent_.max[2]);
    const std::vector<CandidateTiles> tiles = this->cullSlab(hierarchy, extent);
    const std::vector<PolygonChunk> chunks = this->preparePolygons(tiles, extent, atlas);
    this->report((slab + 0.5) * perSlab, "distance field");
    renderer.run(
      [&](SlabRenderer& r)
      {
        if (previousSlices > 0)
        {
          r.carryLastSlice(previousSlices);
        }
        this->renderSlab(r, extent, tiles, chunks, hierarchy.leafSize());
        if (stage != nullptr)
        {
          const Stopwatch watch(statistics_.seconds.medial);
          stage->process(r, extent, previousSlices > 0);
        }
        if (arrays.any())
        {
          const Stopwatch watch(statistics_.seconds.resolve);
          writer.fetch(r, extent);
        }
      });
    if (arrays.any())
    {
      timed(statistics_.seconds.resolve, [&] { this->inArena([&] { writer.store(extent); }); });
    }
    previousSlices = extent.size(2);
  }
}

CandidateHierarchy FieldPipeline::cullBlocks(int slabSlices, TileHull hull)
{
  const Stopwatch watch(statistics_.seconds.cull);
  std::unique_ptr<CandidateHierarchy> hierarchy;
  this->inArena(
    [&]
    {
      hierarchy = std::make_unique<CandidateHierarchy>(filter_, frame_, extent_, hull,
        std::min(slabSlices, CandidateHierarchy::kLeafSize));
    });
  return std::move(*hierarchy);
}

std::vector<CandidateTiles> FieldPipeline::cullSlab(const CandidateHierarchy& hierarchy,
  const Extent& slab)
{
  std::vector<CandidateTiles> tiles;
  this->inArena(
    [&]
    {
      const Stopwatch watch(statistics_.seconds.cull);
      tiles = hierarchy.leafTiles(slab);
    });
  for (const CandidateTiles& block : tiles)
  {
    statistics_.candidatePairs += static_cast<std::int64_t>(block.candidates.size());
    if (query_)
    {
      query_->add(block);
    }
  }
  return tiles;
}

std::vector<PolygonChunk> FieldPipeline::preparePolygons(const std::vector<CandidateTiles>& tiles,
  const Extent& slab, const AtlasLayout& atlas)
{
  std::vector<PolygonChunk> chunks;
  this->inArena(
    [&]
    {
      const Stopwatch watch(statistics_.seconds.polygons);
      chunks = buildPolygons(sites_, frame_, tiles, slab, atlas);
    });
  double area = 0.0;
  for (const PolygonChunk& chunk : chunks)
  {
    statistics_.polygons += chunk.polygons;
    area += chunk.area;
  }
  statistics_.fragments += static_cast<std::int64_t>(area);
  return chunks;
}

void FieldPipeline::renderSlab(SlabRenderer& renderer, const Extent& slab,
  const std::vector<CandidateTiles>& tiles, const std::vector<PolygonChunk>& chunks,
  const glm::ivec3& tileSize)
{
  timed(statistics_.seconds.draw, [&] { renderer.draw(chunks); });
  const Stopwatch watch(statistics_.seconds.resolve);
  if (renderer.resolve(slab) > 0)
  {
    TileQuery query(sites_, filter_, frame_, slab, tileSize);
    for (const CandidateTiles& block : tiles)
    {
      query.add(block);
    }
    repairHoles(renderer, normals_, frame_, query, fieldSign(sign_, topology_), slab);
  }
}

} // namespace medial

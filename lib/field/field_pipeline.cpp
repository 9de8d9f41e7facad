#include "field/field_pipeline.h"

#include "base/stopwatch.h"
#include "field/field_slab.h"
#include "gl/gpu_thread.h"
#include "medial/error.h"
#include "sites/pseudonormals.h"

#include <algorithm>
#include <string>

namespace medial
{
namespace
{

constexpr std::size_t kDefaultMemoryMiB = 512;
/// Slices of a slab where memory allows.
constexpr int kMaxSlices = 64;
SignMethod checkedSign(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, const DistanceFieldOptions& options)
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
  return resolveSignMethod(options.sign, connectivity);
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
  statistics.engine = options.engine != Engine::Auto
    ? options.engine
    : (statistics.device.software ? Engine::Processor : Engine::Rasteriser);
  return statistics;
}

int textureLimit()
{
  GLint limit = 0;
  gl::GpuThread::instance().run([&] { glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit); });
  return limit;
}

} // namespace

FieldPipeline::FieldPipeline(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, const DistanceFieldOptions& options)
  : mesh_(mesh)
  , connectivity_(connectivity)
  , extent_(extent)
  , options_(options)
  , run_(options.execution)
  , frame_(grid)
  , sign_(checkedSign(mesh, connectivity, grid, extent, options))
  , statistics_(newStatistics(extent, options))
  , sites_(this->buildSites())
  , filter_(timed(statistics_.seconds.cull, [&] { return CandidateFilter(sites_); }))
  , normals_(timed(statistics_.seconds.sites,
      [&] { return pseudonormals(sites_, this->fieldSign() == FieldSign::Inward); }))
{
  statistics_.sites = sites_.size();
}

SiteSet FieldPipeline::buildSites()
{
  const Stopwatch watch(statistics_.seconds.sites);
  return run_.onThreads([this] { return SiteSet(mesh_, connectivity_, frame_); });
}

FieldSign FieldPipeline::fieldSign() const
{
  if (sign_ != SignMethod::Pseudonormal)
  {
    return FieldSign::None;
  }
  return connectivity_.signedVolume < 0.0 ? FieldSign::Inward : FieldSign::Outward;
}

int FieldPipeline::slabSlices(std::size_t bytesPerPoint) const
{
  const std::size_t mebibytes = options_.memoryMiB > 0 ? options_.memoryMiB : kDefaultMemoryMiB;
  const std::size_t slice = std::max<std::size_t>(bytesPerPoint, 1) *
    static_cast<std::size_t>(extent_.size(0)) * static_cast<std::size_t>(extent_.size(1));
  const std::size_t fitting = mebibytes * 1024 * 1024 / slice;
  int slices = kMaxSlices;
  while (slices > 1 && static_cast<std::size_t>(slices) > fitting)
  {
    slices /= 2;
  }
  return slices;
}

AtlasLayout FieldPipeline::chooseAtlas(std::size_t bytesPerPoint) const
{
  const int limit = textureLimit();
  int slices = this->slabSlices(bytesPerPoint);
  while (slices > 1 && !AtlasLayout::fits(extent_, slices, limit))
  {
    slices /= 2;
  }
  return AtlasLayout::make(extent_, slices, limit);
}

std::vector<Extent> FieldPipeline::slabsOf(int slices) const
{
  std::vector<Extent> slabs;
  for (int first = extent_.min[2]; first <= extent_.max[2]; first += slices)
  {
    slabs.push_back(extent_);
    slabs.back().min[2] = first;
    slabs.back().max[2] = std::min(first + slices - 1, extent_.max[2]);
  }
  return slabs;
}

FieldWriter FieldPipeline::makeWriter() const
{
  return { mesh_, connectivity_, sites_, frame_, sign_ != SignMethod::None };
}

void FieldPipeline::run(FieldSink& sink, SlabStage* stage)
{
  run_.report(0.0, "distance field");
  nextSeeds_.reset(extent_);
  if (statistics_.engine == Engine::Rasteriser)
  {
    this->rasterise(sink, stage);
  }
  else if (stage != nullptr)
  {
    this->evaluateForStage(sink, *stage);
  }
  else
  {
    this->evaluate(sink);
  }
  std::swap(memory_->seeds, nextSeeds_);
}

CandidateHierarchy FieldPipeline::cullBlocks(int slabSlices, TileHull hull)
{
  const Stopwatch watch(statistics_.seconds.cull);
  std::unique_ptr<CandidateHierarchy> hierarchy;
  run_.onThreads(
    [&]
    {
      hierarchy = std::make_unique<CandidateHierarchy>(filter_, frame_, extent_, hull,
        std::min(slabSlices, CandidateHierarchy::kLeafSize), &memory_->seeds);
    });
  if (hull == TileHull::Cells)
  {
    query_ = std::make_unique<TileQuery>(sites_, filter_, frame_, extent_, hierarchy->leafSize());
  }
  return std::move(*hierarchy);
}

void FieldPipeline::cullSlab(const CandidateHierarchy& hierarchy, Slab& slab,
  const Checkpoint& checkpoint)
{
  const Stopwatch watch(statistics_.seconds.cull);
  run_.onThreads([&] { slab.tiles = hierarchy.leafTiles(slab.extent, &checkpoint); });
  for (const CandidateTiles& block : slab.tiles)
  {
    statistics_.candidatePairs += static_cast<std::int64_t>(block.candidates.size());
    if (query_)
    {
      query_->add(block);
    }
  }
}

FieldPipeline::Renderer& FieldPipeline::obtainRenderer(const AtlasLayout& atlas)
{
  std::unique_ptr<Renderer>& renderer = memory_->renderer;
  if (renderer && renderer->object().atlas() == atlas)
  {
    renderer->run([this](SlabRenderer& r) { r.move(sites_, normals_, frame_, this->fieldSign()); });
  }
  else
  {
    renderer.reset();
    renderer = std::make_unique<Renderer>(sites_, normals_, frame_, atlas, this->fieldSign());
  }
  return *renderer;
}

void FieldPipeline::addGpuSeconds()
{
  statistics_.seconds.draw += gpuSeconds_.draw;
  statistics_.seconds.resolve += gpuSeconds_.resolve;
  statistics_.seconds.medial += gpuSeconds_.medial;
}

} // namespace medial

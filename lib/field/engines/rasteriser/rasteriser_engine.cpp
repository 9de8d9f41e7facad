#include "field/engines/rasteriser/rasteriser_engine.h"

#include "field/engines/rasteriser/rasteriser_run.h"
#include "field/engines/rasteriser/rasteriser_selection.h"
#include "field/slab_culling.h"
#include "field/slabs.h"

namespace medial
{
namespace
{

/// Bytes per grid point of a slab: textures, a ring of two pixel buffers, the textures of the
/// selection, and polygons.
constexpr std::size_t kBytesPerPoint = 112;

} // namespace

RasteriserEngine::RasteriserEngine()
  : thread_(gl::GpuThread::instance())
{
}

void RasteriserEngine::run(const FieldJob& job, FieldSink& sink)
{
  const AtlasLayout atlas = this->chooseAtlas(job, sink);
  SlabCulling culling(job, atlas.slabSlices, TileHull::Points, seeds_);
  RasteriserRun run(job, culling, this->obtainRenderer(job, atlas), sink);
  run.compute(nullptr);
  seeds_ = run.takeSeeds();
}

SelectedField RasteriserEngine::select(const FieldJob& job, const CrossingSelection& wanted,
  FieldSink& sink)
{
  const AtlasLayout atlas = this->chooseAtlas(job, sink);
  SlabCulling culling(job, atlas.slabSlices, TileHull::Cells, seeds_);
  gl::OnGpuThread<RasteriserSelection> selection(wanted, job.frame, job.inside);
  RasteriserRun run(job, culling, this->obtainRenderer(job, atlas), sink);
  run.compute(&selection.object());
  seeds_ = run.takeSeeds();
  return { selection.object().takeCrossings(), culling.takeQuery() };
}

AtlasLayout RasteriserEngine::chooseAtlas(const FieldJob& job, const FieldSink& sink) const
{
  GLint limit = 0;
  thread_.run([&] { glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit); });
  int slices = slabSlices(job.extent, kBytesPerPoint + sink.bytesPerPoint(), job.memoryMiB);
  while (slices > 1 && !AtlasLayout::fits(job.extent, slices, limit))
  {
    slices /= 2;
  }
  return AtlasLayout::make(job.extent, slices, limit);
}

RasteriserEngine::Renderer& RasteriserEngine::obtainRenderer(const FieldJob& job,
  const AtlasLayout& atlas)
{
  if (renderer_ && renderer_->object().atlas() == atlas)
  {
    renderer_->run(
      [&](SlabRenderer& renderer) { renderer.move(job.sites, job.normals, job.frame, job.sign); });
  }
  else
  {
    renderer_.reset();
    renderer_ = std::make_unique<Renderer>(job.sites, job.normals, job.frame, atlas, job.sign);
  }
  return *renderer_;
}

} // namespace medial

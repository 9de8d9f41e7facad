#include "field/engines/rasteriser/rasteriser_engine.h"

#include "base/stopwatch.h"
#include "field/engines/rasteriser/rasteriser_run.h"
#include "field/engines/rasteriser/rasteriser_selection.h"
#include "field/precision_checks.h"
#include "field/slabs.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Bytes per grid point of a slab: textures, a ring of two pixel buffers, the textures of the
/// selection, and rectangles.
constexpr std::size_t kBytesPerPoint = 112;

} // namespace

RasteriserEngine::RasteriserEngine(const std::string& device)
  : thread_(gl::GpuThread::instance(device))
{
}

void RasteriserEngine::run(const FieldJob& job, FieldSink& sink)
{
  requireNear(job);
  const AtlasLayout atlas = this->chooseAtlas(job, sink);
  this->drawOn(atlas, job,
    [&](Renderer& renderer) { RasteriserRun(job, renderer, sink).compute(nullptr); });
}

std::vector<Crossing> RasteriserEngine::select(const FieldJob& job, const CrossingSelection& wanted,
  FieldSink& sink)
{
  requireNear(job);
  const AtlasLayout atlas = this->chooseAtlas(job, sink);
  gl::OnGpuThread<RasteriserSelection> selection(wanted, job.frame, job.insideRows());
  this->drawOn(atlas, job,
    [&](Renderer& renderer) { RasteriserRun(job, renderer, sink).compute(&selection.object()); });
  return selection.object().takeCrossings();
}

template <typename Draw>
void RasteriserEngine::drawOn(const AtlasLayout& atlas, const FieldJob& job, const Draw& draw)
{
  try
  {
    draw(this->obtainRenderer(job, atlas));
  }
  catch (...)
  {
    renderer_.reset(); // its context may be lost
    throw;
  }
}

AtlasLayout RasteriserEngine::chooseAtlas(const FieldJob& job, const FieldSink& sink) const
{
  GLint limit = 0;
  // With a new context, if the last one was lost.
  gl::GpuThread::instance().run([&] { glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit); });
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
  if (!renderer_ || !(renderer_->object().atlas() == atlas))
  {
    renderer_.reset();
    renderer_ = std::make_unique<Renderer>(job.mesh, job.connectivity, atlas);
  }
  const std::vector<glm::vec4>& normals = job.host.signNormals();
  timed(job.statistics.seconds.sites,
    [&] {
      renderer_->run([&](SlabRenderer& renderer) { renderer.move(job.mesh, normals, job.frame); });
    });
  return *renderer_;
}

} // namespace medial

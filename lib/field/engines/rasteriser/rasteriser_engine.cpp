#include "field/engines/rasteriser/rasteriser_engine.h"

#include "field/engines/rasteriser/rasteriser_run.h"
#include "field/engines/rasteriser/rasteriser_selection.h"
#include "field/slabs.h"
#include "medial/error.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace medial
{
namespace
{

/// Bytes per grid point of a slab: textures, a ring of two pixel buffers, the textures of the
/// selection, and polygons.
constexpr std::size_t kBytesPerPoint = 112;
/// Largest distance of a grid point from the surface, local units. Shaders and depths are of single
/// precision; beyond this they would be more than 1e-2 off.
constexpr double kMaxDistance = 32768.0;

/// Checks that no grid point can be too far from the surface.
/// @throws Error InvalidInput.
void requireNear(const FieldJob& job)
{
  const glm::dvec3 middle(0.0);
  double nearest = std::numeric_limits<double>::max();
  for (int site = 0; site < job.sites.size(); ++site)
  {
    nearest = std::min(nearest, glm::length(closestPoint(job.sites, site, middle).point));
  }
  const double farthest = nearest + job.frame.reach();
  if (farthest > kMaxDistance)
  {
    std::ostringstream message;
    message << "grid points may be " << farthest << " times the finest spacing away from the mesh, "
            << "more than " << kMaxDistance << ": this needs the engine processor";
    throw Error(ErrorCode::InvalidInput, message.str());
  }
}

} // namespace

RasteriserEngine::RasteriserEngine(const std::string& device)
  : thread_(gl::GpuThread::instance(device))
{
}

void RasteriserEngine::run(const FieldJob& job, FieldSink& sink)
{
  requireNear(job);
  const AtlasLayout atlas = this->chooseAtlas(job, sink);
  RasteriserRun run(job, this->obtainRenderer(job, atlas), sink);
  run.compute(nullptr);
}

std::vector<Crossing> RasteriserEngine::select(const FieldJob& job, const CrossingSelection& wanted,
  FieldSink& sink)
{
  requireNear(job);
  const AtlasLayout atlas = this->chooseAtlas(job, sink);
  gl::OnGpuThread<RasteriserSelection> selection(wanted, job.frame, job.inside);
  RasteriserRun run(job, this->obtainRenderer(job, atlas), sink);
  run.compute(&selection.object());
  return selection.object().takeCrossings();
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

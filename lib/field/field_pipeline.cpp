#include "field/field_pipeline.h"

#include "base/checkpoint.h"
#include "base/stopwatch.h"
#include "field/field_sign.h"
#include "field/precision_checks.h"
#include "gl/gpu_thread.h"
#include "medial/device.h"
#include "medial/error.h"
#include "mesh/cell_check.h"

namespace medial
{
namespace
{

void checkInput(const TriangleMesh& mesh, const Grid& grid, const Extent& extent)
{
  requireCells(mesh);
  validateGrid(grid);
  if (extent.empty() || !grid.wholeExtent().contains(extent))
  {
    throw Error(ErrorCode::InvalidInput, "the extent is empty or leaves the grid");
  }
}

/// Returns the hardware renderer that is required, whatever the engine.
Device requiredHardware(const std::string& wanted)
{
  Device device = gl::GpuThread::instance(wanted).device();
  if (device.software)
  {
    throw Error(ErrorCode::NoGpu,
      "a hardware renderer is required, but OpenGL runs on " + device.renderer);
  }
  return device;
}

} // namespace

FieldPipeline::FieldPipeline(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Grid& grid, const Extent& extent, const DistanceFieldOptions& options,
  SurfaceOrienter& orienter, const Run& run)
  : mesh_(mesh)
  , connectivity_(connectivity)
  , whole_(grid.wholeExtent())
  , extent_(extent)
  , memoryMiB_(options.memoryMiB)
  , verify_(options.verify)
  , run_(run)
  , frame_(grid)
{
  checkInput(mesh, grid, extent);
  requireSinglePrecision(mesh.bounds(), frame_);
  if (options.requireHardware)
  {
    statistics_.device = requiredHardware(options.device);
  }
  timed(statistics_.seconds.sign,
    [&]
    {
      const Checkpoint checkpoint(run_, 0.0, "distance field");
      run_.onThreads([&]
        { sign_.emplace(options.sign, mesh, connectivity, grid, frame_, orienter, checkpoint); });
    });
  statistics_.sign = sign_->report();
}

InsideQuery FieldPipeline::insideQuery() const
{
  return this->sign() == SignMethod::Winding ? InsideQuery(sign_->surface())
                                             : InsideQuery(mesh_, connectivity_, frame_);
}

void FieldPipeline::run(FieldEngine& engine, FieldSink& sink)
{
  engine.run(this->prepare(engine), sink);
}

std::vector<Crossing> FieldPipeline::run(FieldEngine& engine, FieldSink& sink,
  const CrossingSelection& selection)
{
  return engine.select(this->prepare(engine), selection, sink);
}

FieldJob FieldPipeline::prepare(const FieldEngine& engine)
{
  statistics_.engine = engine.kind();
  if (const std::optional<Device> device = engine.device())
  {
    statistics_.device = device;
  }
  host_.emplace(mesh_, connectivity_, frame_, fieldSign(this->sign(), connectivity_), run_,
    statistics_);
  inside_.reset();
  if (this->sign() == SignMethod::Winding)
  {
    inside_.emplace(*sign_, extent_, run_, statistics_);
  }
  statistics_.sites = static_cast<std::int64_t>(
    mesh_.triangles.size() + connectivity_.edges.size() + mesh_.points.size());
  statistics_.samples = extent_.pointCount();
  run_.report(0.0, "distance field");
  return { mesh_, connectivity_, *host_, fieldSign(this->sign(), connectivity_),
    inside_ ? &*inside_ : nullptr, frame_, whole_, extent_, memoryMiB_, verify_, run_,
    statistics_ };
}

} // namespace medial

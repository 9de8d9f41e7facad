#include "field/engines/device/device_engine.h"

#include "field/engines/device/device_run.h"
#include "field/reach.h"
#include "field/slabs.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Bytes per grid point of a slab: winners, values and sites on the device, and two slabs on their
/// way to the host.
constexpr std::size_t kBytesPerPoint = 64;

} // namespace

DeviceEngine::DeviceEngine()
  : thread_(gl::GpuThread::instance())
{
}

void DeviceEngine::run(const FieldJob& job, FieldSink& sink)
{
  this->compute(job, nullptr, sink);
}

std::vector<Crossing> DeviceEngine::select(const FieldJob& job, const CrossingSelection& selection,
  FieldSink& sink)
{
  return this->compute(job, &selection, sink);
}

std::vector<Crossing> DeviceEngine::compute(const FieldJob& job, const CrossingSelection* selection,
  FieldSink& sink)
{
  requireNear(job);
  const int slices = slabSlices(job.extent, kBytesPerPoint + sink.bytesPerPoint(), job.memoryMiB);
  DeviceRun run(job, thread_, this->obtainField(job), sink);
  return run.compute(slabsOf(job.extent, slices), selection);
}

DeviceEngine::Field& DeviceEngine::obtainField(const FieldJob& job)
{
  if (!field_)
  {
    field_ = std::make_unique<Field>(job.mesh, job.connectivity);
  }
  return *field_;
}

} // namespace medial

#include "field/engines/device/device_engine.h"

#include "field/engines/device/device_run.h"
#include "field/reach.h"
#include "field/slabs.h"
#include "gl/fault.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Bytes per grid point of a slab: winners, values and sites on the device, and two slabs on their
/// way to the host.
constexpr std::size_t kBytesPerPoint = 64;
/// Bytes per grid point of the largest buffer: a distance and a vector.
constexpr std::int64_t kBufferBytes = 16;
/// Of a slab, so that its counters do not overflow.
constexpr std::int64_t kMaxPoints = std::int64_t{ 1 } << 24;

} // namespace

DeviceEngine::DeviceEngine(const std::string& device)
  : thread_(gl::GpuThread::instance(device))
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
  const DeviceCounts before = field_ ? field_->object().counts() : DeviceCounts();
  Field& field = this->obtainField(job);
  DeviceRun run(job, thread_.device(), field, sink, before);
  try
  {
    return run.compute(slabsOf(job.extent, chooseSlices(job, field, sink)), selection);
  }
  catch (...)
  {
    field_.reset(); // whatever was too much must not stay
    throw;
  }
}

int DeviceEngine::chooseSlices(const FieldJob& job, Field& field, const FieldSink& sink)
{
  std::int64_t limit = 0;
  field.run([&](DeviceField& /*field*/) { limit = gl::storageBufferLimit(); });
  const std::int64_t slice = std::int64_t{ job.extent.size(0) } * job.extent.size(1);
  int slices = slabSlices(job.extent, kBytesPerPoint + sink.bytesPerPoint(), job.memoryMiB);
  const std::int64_t points = std::min(limit / kBufferBytes, kMaxPoints);
  while (slices > 1 && slice * (slices + 1) > points)
  {
    slices /= 2;
  }
  return slices;
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

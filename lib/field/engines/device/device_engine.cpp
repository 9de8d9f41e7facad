#include "field/engines/device/device_engine.h"

#include "field/engines/device/device_run.h"
#include "field/precision_checks.h"
#include "field/slabs.h"
#include "gl/fault.h"

#include <algorithm>

namespace medial
{
namespace
{

/// Bytes per grid point of a slab: winners, values, sites and sides on the device, and two slabs on
/// their way to the host.
constexpr std::size_t kBytesPerPoint = 68;
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
  try
  {
    this->obtainField(job);
    const std::vector<Extent> slabs = slabsOf(job.extent, this->chooseSlices(job, sink));
    if (split_)
    {
      return split_->compute(job, thread_.device(), slabs, this->maxPoints(), selection, sink);
    }
    return DeviceRun(job, thread_.device(), *field_, sink, before).compute(slabs, selection);
  }
  catch (...)
  {
    field_.reset(); // whatever was too much must not stay
    split_.reset();
    throw;
  }
}

int DeviceEngine::chooseSlices(const FieldJob& job, const FieldSink& sink) const
{
  const std::size_t parts = split_ ? split_->partCount() : 1;
  const std::int64_t slice = std::int64_t{ job.extent.size(0) } * job.extent.size(1);
  int slices = slabSlices(job.extent, parts * kBytesPerPoint + sink.bytesPerPoint(), job.memoryMiB);
  while (slices > 1 && slice * (slices + 1) > this->maxPoints())
  {
    slices /= 2;
  }
  return slices;
}

std::int64_t DeviceEngine::maxPoints() const
{
  return std::min(bufferLimit_ / kBufferBytes, kMaxPoints);
}

void DeviceEngine::obtainField(const FieldJob& job)
{
  struct Limit
  {
    std::int64_t bytes = gl::storageBufferLimit();
  };
  if (!field_ && !split_)
  {
    bufferLimit_ = gl::OnGpuThread<Limit>().object().bytes;
  }
  const std::int64_t slice = std::int64_t{ job.extent.size(0) } * job.extent.size(1);
  const bool isLarge = slice > this->maxPoints() ||
    DeviceMesh::largestBuffer(job.mesh, job.connectivity) > bufferLimit_;
  if (isLarge && !split_)
  {
    field_.reset();
    split_ = std::make_unique<SplitField>(job.mesh, job.connectivity, bufferLimit_);
  }
  if (!isLarge && !field_)
  {
    split_.reset();
    field_ = std::make_unique<DeviceSlabs::Field>(job.mesh, job.connectivity);
  }
}

} // namespace medial

#include "field/engines/device/device_field.h"

namespace medial
{

DeviceField::DeviceField(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
  : mesh_(mesh, connectivity, kernels_)
  , search_(mesh_, kernels_)
  , values_(mesh_, search_, kernels_)
{
}

void DeviceField::move(const FieldJob& job, const WantedValues& wanted)
{
  mesh_.move(job.mesh, job.frame, job.frame.reach(), kernels_);
  values_.setNormals(job.normals, job.sign);
  values_.setVectors(wanted.vectors);
  wanted_ = wanted;
}

std::vector<std::function<void()>> DeviceField::steps(const FieldJob& job, const Extent& slab,
  int number)
{
  std::vector<std::function<void()>> steps = search_.steps(job.frame, slab);
  steps.emplace_back([this, &job, slab] { values_.resolve(job.frame, slab); });
  steps.emplace_back(
    [this, slab, number]
    { ring_[number % ring_.size()].fetch(values_, search_.counters(), slab, wanted_, kernels_); });
  return steps;
}

bool DeviceField::isHere(int number, std::uint64_t nanoseconds)
{
  return ring_[number % ring_.size()].isHere(nanoseconds);
}

bool DeviceField::grow(int number)
{
  return search_.grow(this->slab(number).counters());
}

} // namespace medial

#include "field/engines/device/device_field.h"

namespace medial
{

DeviceField::DeviceField(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
  : mesh_(mesh, connectivity, kernels_)
  , search_(mesh_, kernels_)
  , inside_(mesh_, kernels_)
  , values_(mesh_, search_, inside_, kernels_)
  , selecting_(mesh_, values_, kernels_)
{
}

void DeviceField::prepare(const FieldJob& job)
{
  mesh_.pack(job.mesh, job.frame, job.frame.reach());
  inside_.prepare(job);
}

void DeviceField::move(const FieldJob& job, const WantedValues& wanted,
  const CrossingSelection* selection)
{
  for (DeviceClock& clock : clocks_)
  {
    clock.reset();
  }
  clocks_[0].begin(&RunStatistics::DeviceSeconds::sites);
  mesh_.move(kernels_);
  values_.setNormals(job.host.signNormals());
  clocks_[0].begin(nullptr);
  values_.setVectors(wanted.vectors);
  wanted_ = wanted;
  selection_ = selection;
  carried_ = 0;
}

void DeviceField::cutRows(const FieldJob& job, const Extent& slab)
{
  inside_.cut(job, slab);
}

std::vector<std::function<void()>> DeviceField::steps(const FieldJob& job,
  const std::vector<Extent>& slabs, int number)
{
  const Extent& slab = slabs[number];
  DeviceClock& clock = clocks_[number % clocks_.size()];
  std::vector<std::function<void()>> steps = search_.steps(job.frame, slab, clock);
  if (selection_ != nullptr && carried_ != number)
  {
    steps.emplace_back([this, below = slabs[number - 1]] { values_.carryLastSlice(below); });
    carried_ = number;
  }
  steps.emplace_back(
    [this, &job, &clock, slab]
    {
      clock.begin(&RunStatistics::DeviceSeconds::resolve);
      values_.resolve(job.frame, slab);
    });
  if (selection_ != nullptr)
  {
    steps.emplace_back(
      [this, &job, &clock, slab]
      {
        clock.begin(&RunStatistics::DeviceSeconds::select);
        selecting_.select(job, *selection_, slab, search_.counters());
      });
  }
  steps.emplace_back(
    [this, &clock, slab, number]
    {
      clock.begin(&RunStatistics::DeviceSeconds::copy);
      ring_[number % ring_.size()].fetch(values_, search_.counters(), slab, wanted_, kernels_);
      clock.begin(nullptr);
    });
  return steps;
}

bool DeviceField::isHere(int number, std::uint64_t nanoseconds,
  RunStatistics::DeviceSeconds& seconds)
{
  if (!ring_[number % ring_.size()].isHere(nanoseconds))
  {
    return false;
  }
  clocks_[number % clocks_.size()].collect(seconds);
  return true;
}

bool DeviceField::grow(int number)
{
  const SearchCounters& counters = this->slab(number).counters();
  return search_.grow(counters) || (selection_ != nullptr && selecting_.grow(counters.listed));
}

void DeviceField::readCrossings(int number)
{
  selecting_.read(this->slab(number).counters().listed);
}

} // namespace medial

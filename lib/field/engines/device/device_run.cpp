#include "field/engines/device/device_run.h"

#include "base/stopwatch.h"

namespace medial
{

WantedValues wantedBy(const FieldArrays& arrays)
{
  WantedValues wanted;
  wanted.distances = arrays.distance != nullptr;
  wanted.vectors = arrays.closestPoint != nullptr;
  wanted.sites = arrays.closestSite || arrays.closestFeature || arrays.closestCell;
  return wanted;
}

DeviceRun::DeviceRun(const FieldJob& job, const Device& device, DeviceSlabs::Field& field,
  FieldSink& sink, const DeviceCounts& before)
  : job_(job)
  , field_(field)
  , sink_(sink)
  , writer_(job, nullptr)
  , check_(job, device)
  , before_(before)
{
}

std::vector<Crossing> DeviceRun::compute(const std::vector<Extent>& slabs,
  const CrossingSelection* selection)
{
  std::vector<Crossing> crossings;
  const double share = 1.0 / static_cast<double>(slabs.size());
  FieldArrays arrays = sink_.slabArrays(slabs[0]);
  WantedValues wanted = wantedBy(arrays);
  wanted.distances = wanted.distances || check_.isDue();
  this->prepareHost();
  DeviceSlabs device(job_, field_, slabs, before_);
  device.move(wanted, selection);
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    const double done = static_cast<double>(i) * share;
    job_.run.report(done, "distance field");
    const Checkpoint checkpoint(job_.run, done, "distance field");
    timed(job_.statistics.seconds.draw,
      [&]
      {
        if (i == 0)
        {
          device.start(i, checkpoint);
        }
        device.finish(i, checkpoint);
        if (selection != nullptr)
        {
          field_.run([&](DeviceField& field) { field.readCrossings(static_cast<int>(i)); });
        }
        if (i + 1 < slabs.size())
        {
          device.start(i + 1, checkpoint);
        }
      });
    if (selection != nullptr)
    {
      field_.object().takeCrossings(crossings);
    }
    if (i > 0)
    {
      arrays = sink_.slabArrays(slabs[i]);
    }
    writer_.begin(slabs[i], arrays);
    timed(job_.statistics.seconds.resolve, [&] { this->store(slabs[i], device.take(i)); });
    sink_.stored(slabs[i]);
  }
  check_.passed();
  device.addCounts();
  return crossings;
}

/// The host's part takes its own time, and none of the GPU thread's.
void DeviceRun::prepareHost() const
{
  job_.host.signNormals();
  if (check_.isDue())
  {
    job_.host.query();
  }
}

void DeviceRun::store(const Extent& slab, const ResolvedSlab& values)
{
  check_.check(slab, values);
  job_.run.onThreads([&] { writer_.store(values); });
}

} // namespace medial

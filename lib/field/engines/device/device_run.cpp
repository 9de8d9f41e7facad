#include "field/engines/device/device_run.h"

#include "base/stopwatch.h"
#include "medial/error.h"

#include <string>

namespace medial
{
namespace
{

WantedValues wantedBy(const FieldArrays& arrays)
{
  WantedValues wanted;
  wanted.distances = arrays.distance != nullptr;
  wanted.vectors = arrays.closestPoint != nullptr;
  wanted.sites = arrays.closestSite || arrays.closestFeature || arrays.closestCell;
  return wanted;
}

} // namespace

DeviceRun::DeviceRun(const FieldJob& job, const Device& device, Field& field, FieldSink& sink,
  const DeviceCounts& before)
  : job_(job)
  , field_(field)
  , sink_(sink)
  , writer_(job)
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
  timed(job_.statistics.seconds.sites,
    [&]
    {
      field_.object().prepare(job_);
      field_.run([&](DeviceField& field) { field.move(job_, wanted, selection); });
    });
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
          this->start(slabs, i, checkpoint);
        }
        this->finish(slabs, i, checkpoint);
        if (selection != nullptr)
        {
          field_.run([&](DeviceField& field) { field.readCrossings(static_cast<int>(i)); });
        }
        if (i + 1 < slabs.size())
        {
          this->start(slabs, i + 1, checkpoint);
        }
      });
    if (selection != nullptr)
    {
      field_.object().takeCrossings(job_, crossings);
    }
    if (i > 0)
    {
      arrays = sink_.slabArrays(slabs[i]);
    }
    writer_.begin(slabs[i], arrays);
    timed(job_.statistics.seconds.resolve, [&] { this->store(slabs[i], i); });
    sink_.stored(slabs[i]);
  }
  check_.passed();
  this->addCounts();
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

void DeviceRun::start(const std::vector<Extent>& slabs, std::size_t number,
  const Checkpoint& checkpoint)
{
  for (const auto& step : field_.object().steps(job_, slabs, static_cast<int>(number)))
  {
    checkpoint();
    field_.run([&step](DeviceField& /*field*/) { step(); });
  }
}

void DeviceRun::finish(const std::vector<Extent>& slabs, std::size_t number,
  const Checkpoint& checkpoint)
{
  constexpr std::uint64_t kWait = 10'000'000; // nanoseconds
  const int id = static_cast<int>(number);
  for (bool grown = true; grown;)
  {
    bool isHere = false;
    while (!isHere)
    {
      field_.run([&](DeviceField& field)
        { isHere = field.isHere(id, kWait, job_.statistics.deviceSeconds); });
      checkpoint();
    }
    grown = field_.object().grow(id);
    if (grown)
    {
      this->start(slabs, number, checkpoint);
    }
  }
}

void DeviceRun::store(const Extent& slab, std::size_t number)
{
  const MappedSlab& mapped = field_.object().slab(static_cast<int>(number));
  const SearchCounters& counters = mapped.counters();
  if (counters.withoutSite > 0)
  {
    throw Error(ErrorCode::NoGpu,
      "the device found no closest site for " + std::to_string(counters.withoutSite) + " of " +
        std::to_string(slab.pointCount()) + " grid points");
  }
  job_.statistics.groupTests += counters.tests;
  job_.statistics.candidatePairs += counters.pairs;
  job_.statistics.fragments += counters.evaluations;
  check_.check(slab, mapped.values());
  job_.run.onThreads([&] { writer_.store(mapped.values()); });
}

void DeviceRun::addCounts()
{
  const DeviceCounts& now = field_.object().counts();
  job_.statistics.bytesUploaded += now.bytesUploaded - before_.bytesUploaded;
  job_.statistics.bytesReadBack += now.bytesReadBack - before_.bytesReadBack;
  job_.statistics.dispatches += now.dispatches - before_.dispatches;
}

} // namespace medial

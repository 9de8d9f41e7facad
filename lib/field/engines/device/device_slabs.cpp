#include "field/engines/device/device_slabs.h"

#include "base/stopwatch.h"
#include "medial/error.h"

#include <string>

namespace medial
{
namespace
{

constexpr std::uint64_t kWait = 10'000'000; ///< before asking again, nanoseconds

} // namespace

DeviceSlabs::DeviceSlabs(const FieldJob& job, Field& field, const std::vector<Extent>& slabs,
  const DeviceCounts& before)
  : job_(job)
  , field_(field)
  , slabs_(slabs)
  , before_(before)
{
}

void DeviceSlabs::move(const WantedValues& wanted, const CrossingSelection* selection)
{
  timed(job_.statistics.seconds.sites,
    [&]
    {
      field_.object().prepare(job_);
      field_.run([&](DeviceField& field) { field.move(job_, wanted, selection); });
    });
}

void DeviceSlabs::start(std::size_t number, const Checkpoint& checkpoint)
{
  if (job_.inside != nullptr)
  {
    this->windRows(slabs_[number], checkpoint);
  }
  for (const auto& step : field_.object().steps(job_, slabs_, static_cast<int>(number)))
  {
    checkpoint();
    field_.run([&step](DeviceField& /*field*/) { step(); });
  }
}

void DeviceSlabs::windRows(const Extent& slab, const Checkpoint& checkpoint)
{
  checkpoint();
  field_.run([&](DeviceField& field) { field.cutRows(job_, slab); });
  for (bool cut = false; !cut;)
  {
    checkpoint();
    field_.run([&](DeviceField& field) { cut = field.areRowsCut(kWait); });
  }
  field_.object().decideRows(job_, slab);
  field_.run([&](DeviceField& field) { field.windRows(slab); });
}

void DeviceSlabs::finish(std::size_t number, const Checkpoint& checkpoint)
{
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
      this->start(number, checkpoint);
    }
  }
}

ResolvedSlab DeviceSlabs::take(std::size_t number)
{
  const MappedSlab& mapped = field_.object().slab(static_cast<int>(number));
  const SearchCounters& counters = mapped.counters();
  if (counters.withoutSite > 0)
  {
    throw Error(ErrorCode::NoGpu,
      "the device found no closest site for " + std::to_string(counters.withoutSite) + " of " +
        std::to_string(slabs_[number].pointCount()) + " grid points");
  }
  job_.statistics.groupTests += counters.tests;
  job_.statistics.candidatePairs += counters.pairs;
  job_.statistics.fragments += ElementSearch::kPointsOfBlock * std::int64_t{ counters.evaluations };
  return mapped.values();
}

void DeviceSlabs::addCounts()
{
  const DeviceCounts& now = field_.object().counts();
  job_.statistics.bytesUploaded += now.bytesUploaded - before_.bytesUploaded;
  job_.statistics.bytesReadBack += now.bytesReadBack - before_.bytesReadBack;
  job_.statistics.dispatches += now.dispatches - before_.dispatches;
}

} // namespace medial

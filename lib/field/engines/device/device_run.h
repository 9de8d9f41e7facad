#pragma once

#include "field/engines/device/device_slabs.h"
#include "field/engines/device/self_check.h"
#include "field/field_job.h"
#include "field/field_writer.h"
#include "medial/distance_field.h"

#include <vector>

namespace medial
{

/// The values that arrays need.
WantedValues wantedBy(const FieldArrays& arrays);

/// One job of the engine `device`. While the device works on a slab, the host stores the one
/// before.
class DeviceRun
{
public:
  /// @param before what the device had done before the job.
  DeviceRun(const FieldJob& job, const Device& device, DeviceSlabs::Field& field, FieldSink& sink,
    const DeviceCounts& before);

  /// Computes slabs. To be called once.
  /// @param selection of crossings; null if none are wanted.
  std::vector<Crossing> compute(const std::vector<Extent>& slabs,
    const CrossingSelection* selection);

private:
  void prepareHost() const;
  void store(const Extent& slab, const ResolvedSlab& values);

  const FieldJob& job_;
  DeviceSlabs::Field& field_;
  FieldSink& sink_;
  FieldWriter writer_;
  SelfCheck check_;
  DeviceCounts before_;
};

} // namespace medial

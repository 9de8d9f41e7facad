#pragma once

#include "base/checkpoint.h"
#include "field/engines/device/device_field.h"
#include "field/field_job.h"
#include "gl/gpu_thread.h"

#include <vector>

namespace medial
{

/// The slabs of a job over one mesh on the device, from the caller's thread.
class DeviceSlabs
{
public:
  using Field = gl::OnGpuThread<DeviceField>;

  /// @param job, field, slabs must outlive this.
  /// @param before what the device had done before the job.
  DeviceSlabs(const FieldJob& job, Field& field, const std::vector<Extent>& slabs,
    const DeviceCounts& before);

  /// Takes over the job's positions.
  /// @param selection of crossings; null if none are wanted.
  void move(const WantedValues& wanted, const CrossingSelection* selection);

  void start(std::size_t number, const Checkpoint& checkpoint);
  /// Waits for a slab, and computes it again where something had too little room.
  void finish(std::size_t number, const Checkpoint& checkpoint);

  /// Of a slab that is finished; adds its work to the statistics.
  /// @throws Error NoGpu if grid points are left without a site.
  ResolvedSlab take(std::size_t number);
  /// Adds what was moved and started to the statistics.
  void addCounts();

private:
  void windRows(const Extent& slab, const Checkpoint& checkpoint);

  const FieldJob& job_;
  Field& field_;
  const std::vector<Extent>& slabs_;
  DeviceCounts before_;
};

} // namespace medial

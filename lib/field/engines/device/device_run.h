#pragma once

#include "base/checkpoint.h"
#include "field/engines/device/device_field.h"
#include "field/engines/device/self_check.h"
#include "field/field_job.h"
#include "field/field_writer.h"
#include "gl/gpu_thread.h"
#include "medial/distance_field.h"

#include <functional>
#include <vector>

namespace medial
{

/// One job of the engine `device`. While the device works on a slab, the host stores the one
/// before.
class DeviceRun
{
public:
  using Field = gl::OnGpuThread<DeviceField>;

  /// @param before what the device had done before the job.
  DeviceRun(const FieldJob& job, const Device& device, Field& field, FieldSink& sink,
    const DeviceCounts& before);

  /// Computes slabs. To be called once.
  /// @param selection of crossings; null if none are wanted.
  std::vector<Crossing> compute(const std::vector<Extent>& slabs,
    const CrossingSelection* selection);

private:
  void prepareHost() const;
  void start(const std::vector<Extent>& slabs, std::size_t number, const Checkpoint& checkpoint);
  /// Waits for a slab, and computes it again where something had too little room.
  void finish(const std::vector<Extent>& slabs, std::size_t number, const Checkpoint& checkpoint);
  void store(const Extent& slab, std::size_t number);
  void addCounts();

  const FieldJob& job_;
  Field& field_;
  FieldSink& sink_;
  FieldWriter writer_;
  SelfCheck check_;
  DeviceCounts before_;
};

} // namespace medial

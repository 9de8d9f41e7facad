#pragma once

#include "field/engines/device/device_mesh.h"
#include "field/engines/device/element_search.h"
#include "field/engines/device/kernels.h"
#include "field/engines/device/mapped_slab.h"
#include "field/engines/device/slab_values.h"
#include "field/field_job.h"

#include <array>
#include <functional>
#include <vector>

namespace medial
{

/// The field of a mesh on the device, frame after frame and slab after slab. Lives on the GPU
/// thread.
class DeviceField
{
public:
  /// @throws Error GpuLimit or OutOfMemory.
  DeviceField(const TriangleMesh& mesh, const MeshConnectivity& connectivity);

  /// Takes over the positions of a job over the same mesh.
  void move(const FieldJob& job, const WantedValues& wanted);

  /// Returns what there is to do for a slab, in steps of limited time, for the GPU thread.
  /// @param number of the slab, from 0 on in ascending z.
  std::vector<std::function<void()>> steps(const FieldJob& job, const Extent& slab, int number);

  /// Waits for a slab, for a while.
  bool isHere(int number, std::uint64_t nanoseconds);
  /// Makes room for what a slab had too little of, so that it has to be computed again.
  /// @return whether there was too little.
  bool grow(int number);

  /// Of a slab that is here; valid until the next but one starts.
  const MappedSlab& slab(int number) const { return ring_[number % ring_.size()]; }
  /// Since this was made.
  const DeviceCounts& counts() const { return kernels_.counts(); }

private:
  Kernels kernels_;
  DeviceMesh mesh_;
  ElementSearch search_;
  SlabValues values_;
  WantedValues wanted_;
  std::array<MappedSlab, 2> ring_;
};

} // namespace medial

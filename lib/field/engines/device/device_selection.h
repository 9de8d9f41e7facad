#pragma once

#include "field/crossing.h"
#include "field/engines/device/device_mesh.h"
#include "field/engines/device/kernels.h"
#include "field/engines/device/slab_values.h"
#include "field/field_job.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Selects crossings where the field lies, slab by slab. GPU thread only, but for take().
class DeviceSelection
{
public:
  /// @param mesh, values, kernels must outlive this.
  DeviceSelection(const DeviceMesh& mesh, const SlabValues& values, Kernels& kernels);

  /// Marks and lists the crossings of a slab, and adds their number to the counters of the slab.
  /// Those of the last slice wait for the slice above, so that the order of crossings (by z, y,
  /// axis and x) does not depend on the slabs.
  void select(const FieldJob& job, const CrossingSelection& selection, const Extent& slab,
    const gl::Buffer& counters);

  /// Makes room for the crossings of a slab.
  /// @return whether there was too little.
  bool grow(std::uint32_t crossings);

  /// Reads the crossings of a slab back.
  /// @param count of the slab.
  void read(std::uint32_t count);
  /// Appends those that were read last. Needs no OpenGL: for the caller's thread.
  void take(std::vector<Crossing>& crossings) const;

private:
  /// As list_crossings.comp has it.
  using Packed = std::array<std::uint32_t, 4>;

  void mark(const FieldJob& job, const CrossingSelection& selection, const Extent& slab);

  const DeviceMesh& mesh_;
  const SlabValues& values_;
  Kernels& kernels_;
  std::int64_t room_ = 0; ///< of the list, crossings
  gl::Buffer marks_, rowCounts_, list_;
  std::vector<Packed> packed_;
};

} // namespace medial

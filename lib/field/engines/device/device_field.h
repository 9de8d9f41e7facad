#pragma once

#include "field/engines/device/device_clock.h"
#include "field/engines/device/device_mesh.h"
#include "field/engines/device/device_selection.h"
#include "field/engines/device/element_search.h"
#include "field/engines/device/inside_bits.h"
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
/// thread; what needs no OpenGL says so, and is for the caller's thread while none of its jobs
/// runs.
class DeviceField
{
public:
  /// @throws Error GpuLimit or OutOfMemory.
  DeviceField(const TriangleMesh& mesh, const MeshConnectivity& connectivity);

  /// The host's part of move(). Needs no OpenGL.
  void prepare(const FieldJob& job);
  /// Takes over the positions of a job over the same mesh, after prepare().
  /// @param selection of crossings; null if none are wanted. Must outlive the job.
  void move(const FieldJob& job, const WantedValues& wanted, const CrossingSelection* selection);

  ///@{
  /// Which grid points of a slab are inside, as InsideBits finds them; to be known before steps().
  void cutRows(const FieldJob& job, const Extent& slab);
  bool areRowsCut(std::uint64_t nanoseconds) { return inside_.isCut(nanoseconds); }
  /// The host's part. Needs no OpenGL.
  void decideRows(const FieldJob& job, const Extent& slab) { inside_.decide(job, slab); }
  void windRows(const Extent& slab) { inside_.wind(slab); }
  ///@}

  /// Returns what there is to do for a slab, in steps of limited time, for the GPU thread.
  /// @param slabs of the job, in ascending z.
  std::vector<std::function<void()>> steps(const FieldJob& job, const std::vector<Extent>& slabs,
    int number);

  /// Waits for a slab, for a while.
  /// @param seconds gets those of the slab once it is here.
  bool isHere(int number, std::uint64_t nanoseconds, RunStatistics::DeviceSeconds& seconds);
  /// Makes room for what a slab had too little of, so that it has to be computed again.
  /// @return whether there was too little.
  bool grow(int number);

  /// Reads the crossings of a slab that is here; to be called before the next one starts.
  void readCrossings(int number);
  /// Appends those that were read last. Needs no OpenGL.
  void takeCrossings(std::vector<Crossing>& crossings) const { selecting_.take(crossings); }

  /// Of a slab that is here; valid until the next but one starts.
  const MappedSlab& slab(int number) const { return ring_[number % ring_.size()]; }
  /// Since this was made.
  const DeviceCounts& counts() const { return kernels_.counts(); }

private:
  Kernels kernels_;
  DeviceMesh mesh_;
  ElementSearch search_;
  InsideBits inside_;
  SlabValues values_;
  DeviceSelection selecting_;
  WantedValues wanted_;
  const CrossingSelection* selection_ = nullptr;
  int carried_ = 0; ///< number of the slab that has the slice below
  std::array<MappedSlab, 2> ring_;
  std::array<DeviceClock, 2> clocks_;
};

} // namespace medial

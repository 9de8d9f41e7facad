#pragma once

#include "field/engines/device/awaited_fence.h"
#include "field/engines/device/element_search.h"
#include "field/engines/device/kernels.h"
#include "field/engines/device/slab_values.h"
#include "field/field_writer.h"
#include "gl/gl_objects.h"
#include "medial/grid.h"

#include <cstdint>

namespace medial
{

/// Which arrays of a slab leave the device.
struct WantedValues
{
  bool distances = false;
  bool vectors = false; ///< to closest points
  bool sites = false;
};

/// Receives the values of a slab in host memory, while the device works on the next slab; two of
/// them make a ring. Created, used and destroyed on the GPU thread, except for the accessors.
class MappedSlab
{
public:
  /// Starts copying; isHere() tells when it is done.
  /// @throws Error GpuLimit or OutOfMemory.
  void fetch(const SlabValues& values, const gl::Buffer& counters, const Extent& slab,
    const WantedValues& wanted, Kernels& kernels);

  /// Waits for the values, for a while.
  /// @throws Error NoGpu if the device was reset or does not finish.
  bool isHere(std::uint64_t nanoseconds) { return fence_.isReached(nanoseconds); }

  /// Available once the values are here.
  const SearchCounters& counters() const { return *counters_.values; }
  ResolvedSlab values() const;

private:
  template <typename T>
  struct Mapped
  {
    gl::Buffer buffer;
    const T* values = nullptr;
    std::int64_t bytes = 0;
  };

  template <typename T>
  static void obtain(Mapped<T>& mapped, std::int64_t bytes);

  WantedValues wanted_;
  std::int64_t points_ = 0;
  Mapped<SearchCounters> counters_;
  Mapped<float> distances_;
  Mapped<float> vectors_;
  Mapped<std::int32_t> sites_;
  AwaitedFence fence_;
};

} // namespace medial

#pragma once

#include "field/engines/device/awaited_fence.h"
#include "field/engines/device/device_mesh.h"
#include "field/engines/device/kernels.h"
#include "field/field_job.h"
#include "medial/grid.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// Which grid points of a slab, and of the slice below it, are inside, where winding numbers tell:
/// exactly those of InsideRows, as bits on the device.
///
/// The device finds where rows pass through faces. Its positions are rounded, so it leaves every
/// crossing that rounding could change to the host. Where holes have lids, the host does it all.
/// GPU thread only, but for prepare() and decide(), which are for the caller's thread while no job
/// of this mesh runs.
class InsideBits
{
public:
  /// @param mesh, kernels must outlive this.
  InsideBits(const DeviceMesh& mesh, Kernels& kernels);

  /// Takes over how the faces of a job count, if winding numbers tell.
  void prepare(const FieldJob& job);

  /// Starts finding where the rows of a slab pass through faces.
  void cut(const FieldJob& job, const Extent& slab);
  /// Waits for that, for a while.
  bool isCut(std::uint64_t nanoseconds);
  /// Decides what the device has left in doubt.
  void decide(const FieldJob& job, const Extent& slab);
  /// Makes the bits.
  void wind(const Extent& slab);

  /// Null unless winding numbers tell.
  const gl::Buffer* bits() const { return isWanted_ ? &bits_ : nullptr; }

private:
  struct Doubt
  {
    std::int32_t face;
    std::int32_t slice;
    std::int32_t row;
  };

  void uploadWeights();

  const DeviceMesh& mesh_;
  Kernels& kernels_;
  bool isWanted_ = false;
  bool hasLids_ = false;
  bool byHost_ = false; ///< whether the host finds all changes of the slab
  std::vector<std::int32_t> weights_;
  bool isUploaded_ = false;       ///< the weights
  std::vector<Doubt> doubts_;     ///< of the slab
  std::vector<glm::ivec2> found_; ///< place and change, by the host
  gl::Buffer weightBuffer_, doubtBuffer_, foundBuffer_, changes_, bits_;
  AwaitedFence fence_;
};

} // namespace medial

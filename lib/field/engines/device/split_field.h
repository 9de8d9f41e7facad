#pragma once

#include "field/engines/device/device_slabs.h"
#include "field/engines/device/mesh_parts.h"
#include "field/field_job.h"
#include "medial/device.h"
#include "medial/distance_field.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace medial
{

/// The field of a mesh, or on a grid, that is larger than a storage buffer may be. Parts of the
/// mesh, which have everything on the device, take turns, and so do bands: some rows of a slice.
/// The host keeps the nearest site of each grid point, of equally near ones the lowest, and selects
/// crossings.
class SplitField
{
public:
  /// A part, and its field.
  struct Part
  {
    MeshPart mesh;
    std::unique_ptr<DeviceSlabs::Field> field;
    DeviceCounts counted; ///< that the statistics of jobs have
  };

  /// @param limit of a storage buffer, bytes.
  /// @throws Error GpuLimit or OutOfMemory.
  SplitField(const TriangleMesh& mesh, const MeshConnectivity& connectivity, std::int64_t limit);

  int partCount() const { return static_cast<int>(parts_.size()); }

  /// Computes a job over the same mesh.
  /// @param maxPoints of a band. Slabs that have more must have one slice.
  /// @param selection of crossings; null if none are wanted.
  /// @param device what to blame for a wrong field.
  std::vector<Crossing> compute(const FieldJob& job, const Device& device,
    const std::vector<Extent>& slabs, std::int64_t maxPoints, const CrossingSelection* selection,
    FieldSink& sink);

private:
  std::vector<Part> parts_;
};

} // namespace medial

#pragma once

#include "culling/tile_query.h"
#include "field/crossing.h"
#include "field/field_job.h"
#include "medial/device.h"
#include "medial/distance_field.h"
#include "medial/engine.h"

#include <memory>
#include <optional>
#include <vector>

namespace medial
{

/// What the medial stage takes from an engine.
struct SelectedField
{
  std::vector<Crossing> crossings;  ///< slice after slice, in ascending z
  std::unique_ptr<TileQuery> query; ///< exact closest points anywhere in the job's extent
};

/// Finds the closest sites of grid points, slab by slab in ascending z, and writes what a sink
/// wants to know of them.
///
/// All engines give the same field (ids: except between sites at equal distance) and the same
/// crossings (except at the thresholds). How they cut the extent into slabs, where they keep these
/// and what runs at the same time is theirs: slabsOf(), SlabCulling and FieldWriter are there for
/// those that work on the host. An engine that draws or dispatches asks for its device when it is
/// made; no other touches OpenGL.
///
/// An engine serves one mesh. From job to job its points may move; what does not depend on them
/// stays where it is (on a device only positions are uploaded), and the closest sites of one job
/// bound the distances of the next.
class FieldEngine
{
public:
  virtual ~FieldEngine() = default;

  virtual Engine kind() const = 0;
  /// What it computes on, if that is OpenGL.
  virtual std::optional<Device> device() const = 0;

  /// Computes a field.
  /// @throws Error GpuLimit, OutOfMemory, Cancelled, and what the sink throws.
  virtual void run(const FieldJob& job, FieldSink& sink) = 0;

  /// Computes a field and selects crossings where it lies, so that of the slabs only what the sink
  /// wants need leave a device.
  /// @throws Error as run(), and as requireRoomForAxis().
  virtual SelectedField select(const FieldJob& job, const CrossingSelection& selection,
    FieldSink& sink) = 0;
};

} // namespace medial

#pragma once

#include "field/crossing.h"
#include "field/field_job.h"
#include "medial/device.h"
#include "medial/distance_field.h"
#include "medial/engine.h"

#include <optional>
#include <vector>

namespace medial
{

/// Finds the closest sites of grid points, slab by slab in ascending z, and writes the arrays that
/// a sink wants.
///
/// All engines give the same field (ids may differ between sites at equal distance) and the same
/// crossings (except at the thresholds). Each engine decides how it cuts the extent into slabs,
/// where it keeps them and what runs at the same time. slabsOf(), CandidateHierarchy and
/// FieldWriter help engines that work on the host. An engine that draws or dispatches asks for its
/// device when it is made; no other engine touches OpenGL.
///
/// An engine serves one mesh, whose points may move from job to job. Whatever does not depend on
/// the positions stays where it is: a device only receives new positions.
class FieldEngine
{
public:
  virtual ~FieldEngine() = default;

  virtual Engine kind() const = 0;
  /// Whether it is what options ask for.
  virtual bool serves(Engine wanted) const { return wanted == this->kind(); }
  /// The device that it computes on, if it uses OpenGL.
  virtual std::optional<Device> device() const = 0;

  /// Computes a field.
  /// @throws Error GpuLimit, OutOfMemory, Cancelled, and any exception of the sink.
  virtual void run(const FieldJob& job, FieldSink& sink) = 0;

  /// Computes a field and selects crossings where the field lies, so that only the arrays which the
  /// sink wants have to leave a device. Crossings come slice by slice, in ascending z.
  /// @throws Error as run(), and as requireRoomForAxis().
  virtual std::vector<Crossing> select(const FieldJob& job, const CrossingSelection& selection,
    FieldSink& sink) = 0;
};

} // namespace medial

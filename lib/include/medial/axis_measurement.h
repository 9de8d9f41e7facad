#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/medial_model.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <cstdint>

namespace medial
{

/// Default number of samples on the surface of the mesh.
constexpr std::int64_t kDefaultMeasureSamples = 100000;
/// Least number of samples.
constexpr std::int64_t kMinMeasureSamples = 1000;
/// Largest number of samples.
constexpr std::int64_t kMaxMeasureSamples = 100000000;

/// How an axis is measured.
struct MeasurementOptions
{
  /// Number of samples on the surface of the mesh, in [1000, 100000000]; the surface of the union
  /// gets as many per area, and fewer where its bounds are more than four times as large as the
  /// mesh's.
  std::int64_t samples = kDefaultMeasureSamples;
  Execution execution; ///< threads, progress and cancelling
};

/// Lengths of many places; world units.
struct Deviation
{
  double max = 0.0;        ///< maximum
  double mean = 0.0;       ///< over the places
  std::int64_t places = 0; ///< that the mean is over
};

/// How well a medial axis describes a mesh.
struct MEDIAL_EXPORT AxisMeasurement
{
  double diagonal = 0.0; ///< of the mesh's bounds, world units

  /// Distances from the mesh to the surface of the union of balls, cones and wedges: from samples
  /// evenly spread by area, and for the maximum from all points of the mesh as well. At samples
  /// outside the union the distance is exact. Inside it is that to a point of the union's surface
  /// found nearby, so that it is never too small.
  Deviation surfaceToUnion;
  /// Distances from the surface of the union to the mesh, exact: from samples on the surfaces of
  /// balls, cones and wedges, evenly spread by area, that are not inside another one.
  Deviation unionToSurface;
  /// |radius - distance from the centre to the mesh| over the balls.
  Deviation radiusError;

  /// The greater of the two one-sided maxima: the Hausdorff distance, as far as samples show it.
  double hausdorff() const;
  /// Mean of the two one-sided means.
  double meanDistance() const;

  bool knowsInside = false;       ///< false for a mesh that is open or not consistently oriented
  std::int64_t centresInside = 0; ///< balls whose centre is inside the mesh; 0 where unknown
  ModelCounts counts;             ///< of the axis
};

/// Measures an axis against the mesh that it is the axis of. The result depends neither on the
/// number of threads nor on chance.
/// @throws Error InvalidInput as checkMedialModel(), for a mesh without area, and for a number of
///   samples or threads outside its range; Cancelled.
MEDIAL_EXPORT AxisMeasurement measureAxis(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const MedialModel& model,
  const MeasurementOptions& options = {});

} // namespace medial

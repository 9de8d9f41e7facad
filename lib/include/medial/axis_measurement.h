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
/// Smallest number of samples.
constexpr std::int64_t kMinMeasureSamples = 1000;
/// Largest number of samples.
constexpr std::int64_t kMaxMeasureSamples = 100000000;

/// How an axis is measured.
struct MeasurementOptions
{
  /// Number of samples on the surface of the mesh, in [1000, 100000000]. The surface of the union
  /// gets as many per unit area, but fewer if its bounds are more than four times as large as those
  /// of the mesh, and more if it would get fewer than 100.
  std::int64_t samples = kDefaultMeasureSamples;
  Execution execution; ///< threads, progress and cancelling
};

/// Lengths measured at many places, world units.
struct Deviation
{
  double max = 0.0;        ///< largest length
  double mean = 0.0;       ///< mean length
  std::int64_t places = 0; ///< number of places
};

/// How well a medial axis describes a mesh.
struct MEDIAL_EXPORT AxisMeasurement
{
  double diagonal = 0.0; ///< of the bounds of the mesh, world units

  /// Distances from the mesh to the surface of the union of balls, cones and wedges. They are
  /// measured at samples spread evenly by area; the maximum includes all points of the mesh as
  /// well. At samples outside the union they are exact. Inside, each is the distance to a point
  /// found nearby on the union's surface, and so never too small.
  Deviation surfaceToUnion;
  /// Distances from the surface of the union to the mesh, exact. The samples are spread evenly by
  /// area over the surfaces of balls, cones and wedges; those inside another ball, cone or wedge
  /// are left out. The maximum includes a point of each ball that shows as well. Where the union
  /// has no area, these points are the samples; a ball of radius 0 is its centre.
  Deviation unionToSurface;
  /// |radius - distance from the centre to the mesh| of the balls.
  Deviation radiusError;

  /// The larger of the two one-sided maxima: the Hausdorff distance, as far as the samples show it.
  double hausdorff() const;
  /// The mean of the two one-sided means.
  double meanDistance() const;

  bool knowsInside = false;       ///< whether the mesh is closed
  std::int64_t centresInside = 0; ///< balls whose centre lies inside the mesh; 0 if !knowsInside
  ModelCounts counts;             ///< of the axis
};

/// Measures how well an axis describes its mesh. The result is the same for every number of threads
/// and every call.
/// @throws Error InvalidInput for a mesh without area, a number of samples or threads outside its
///   range, and as checkMedialModel(); Cancelled.
MEDIAL_EXPORT AxisMeasurement measureAxis(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const MedialModel& model,
  const MeasurementOptions& options = {});

} // namespace medial

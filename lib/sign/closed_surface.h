#pragma once

#include "medial/triangle_mesh.h"
#include "sign/surface_orientation.h"
#include "sites/local_coordinates.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Weighted triangles and their points in local coordinates.
struct TriangleChain
{
  std::vector<glm::dvec3> points;
  std::vector<WeightedTriangle> triangles;

  std::array<glm::dvec3, 3> cornersOf(const WeightedTriangle& triangle) const
  {
    const auto& [a, b, c] = triangle.corners;
    return { points[a], points[b], points[c] };
  }
};

/// Returns the area of a triangle, twice, as often as it counts.
double countedArea(const TriangleChain& chain, const WeightedTriangle& triangle);

/// An oriented surface and lids for its holes. Together they have no rim, so every point that is on
/// none of them has a winding number that is an integer.
struct ClosedSurface
{
  TriangleChain chain;      ///< the triangles of the surface, then those of the lids
  std::size_t firstLid = 0; ///< first triangle of the lids
  std::int64_t holes = 0;   ///< connected pieces of the rim

  /// Returns the triangles of the lids.
  TriangleChain lids() const;

  /// Returns the area of the lids over that of all triangles, lids included; each as often as it
  /// counts.
  double lidShare() const;
};

/// Returns the triangles of a surface, as they count.
TriangleChain chainOf(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
  const LocalCoordinates& local);

/// Closes an oriented surface.
ClosedSurface closeSurface(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
  const LocalCoordinates& local);

} // namespace medial

#pragma once

#include "medial/triangle_mesh.h"
#include "sign/surface_orientation.h"
#include "sites/local_coordinates.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace medial
{

/// A triangle that counts `weight` times, as seen from the side where its corners run
/// counterclockwise.
struct WeightedTriangle
{
  std::array<int, 3> corners;
  int weight;
};

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

/// An oriented surface and lids for its holes. Together they have no rim, so every point that is on
/// none of them has a winding number that is an integer.
struct ClosedSurface
{
  TriangleChain chain; ///< the triangles of the surface, then those of the lids
  /// First triangle of every lid, and the end.
  std::vector<std::size_t> lidOffsets;

  std::size_t lidCount() const { return lidOffsets.size() - 1; }
  /// Returns the triangles of one lid; the first two corners of each are on the rim.
  TriangleChain lid(std::size_t index) const;
};

/// Returns the triangles of a surface, as they count.
TriangleChain chainOf(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
  const LocalCoordinates& local);

/// Closes an oriented surface.
ClosedSurface closeSurface(const TriangleMesh& mesh, const SurfaceOrientation& orientation,
  const LocalCoordinates& local);

} // namespace medial

#pragma once

#include "medial/grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Limits the time that the polygons of a mesh take together: it grows with the square of their
/// corners, so that a small file could ask for hours.
class TriangulationEffort
{
public:
  /// Called before a polygon.
  void begin(std::size_t corners) { corners_ = corners; }
  /// Counts corners that were looked at, if the polygon has many.
  /// @throws Error InvalidInput when the polygons of the mesh have used up what they may.
  void spend(std::int64_t steps);

private:
  std::int64_t left_ = 2'000'000'000; // about seven seconds
  std::size_t corners_ = 0;           // of the polygon
};

/// Splits a simple, possibly concave and roughly planar polygon into triangles.
///
/// Ears are clipped in the projection along the main axis of the Newell normal. A quad is split
/// along its valid diagonal, or along the shorter one if both are valid. A polygon that is not
/// simple still gives triangles over its corners; one without a normal gives a fan. The triangles
/// depend neither on the corner that comes first nor on the way round: two faces back to back
/// become the same triangles, turned round.
///
/// @param corners in order, at least three.
/// @param effort of all polygons of the mesh.
/// @return corners.size() - 2 triples of indices into `corners`, wound like the polygon.
/// @throws Error InvalidInput for a mesh whose polygons take too long.
std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Point3>& corners,
  TriangulationEffort& effort);

} // namespace medial

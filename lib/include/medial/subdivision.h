#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <vector>

namespace medial
{

/// A mesh of the same shape with shorter edges.
struct Subdivision
{
  /// Points of the original come first, new points after them; the cells of triangles are those of
  /// the original, but triangles without area go: see subdivide(). Segments and vertices are those
  /// of the original.
  TriangleMesh mesh;
  /// Per new point, the two points, with lower ids, that it is in the middle of.
  std::vector<std::array<int, 2>> parents;

  /// Number of the points of the original.
  std::size_t originalPoints() const { return mesh.points.size() - parents.size(); }
};

/// Halves the edges of triangles that are longer than a limit, until there are none: this gives a
/// mesh points inside its large faces. Triangles that share an edge share its middle, so no cracks
/// appear. The result is the same for every call.
///
/// Before that, triangles without area go, and so do those nearly without, if two of their angles
/// are at most 2e-5 radians: the triangles at their longest edge are divided at the corner
/// opposite, so that what is beside them meets. They stay if the mesh has no other triangles.
/// @param maxEdge world units, in (0, infinity).
/// @throws Error InvalidInput for a limit outside its range, or one that would make more than
///   100,000,000 triangles; Cancelled; OutOfMemory.
MEDIAL_EXPORT Subdivision subdivide(const TriangleMesh& mesh, double maxEdge,
  const Execution& execution = {});

} // namespace medial

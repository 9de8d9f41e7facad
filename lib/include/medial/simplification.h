#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/medial_axis.h"

#include <cstdint>

namespace medial
{

/// How far an axis is simplified.
struct SimplificationOptions
{
  /// Most balls, that is points, of the result; >= 1. A few hundred describe a shape, as few as its
  /// features can be counted; fewer make it rounder.
  std::int64_t maxSpheres = 200;
  Execution execution; ///< threads, progress and cancelling
};

/// A compact axis of at most options.maxSpheres balls, whose union with the cones between the two
/// balls of a line (or of an edge of a triangle) and the wedges between the three of a triangle
/// approximates the shape: quadric edge collapse of the points (x, y, z, radius) of R^4 (spherical
/// quadrics: Thiery, Guy, Boubekeur, "Sphere-Meshes", 2013; of wedges: Li, Wang, Sun, Guo, Zhang,
/// Wang, "Q-MAT: Computing Medial Axis Transform by Quadratic Error Minimization", 2015).
///
/// The order of the steps:
/// 1. Quads become triangles. Components whose balls overlap are joined by a line between their
///    nearest balls: they are parts of one solid that the selection has cut apart.
/// 2. Edges are contracted, the one first that adds least to the squared distance between the balls
///    and the tangent planes of the boundary that they stand for. Components, loops and hollows
///    stay, but for loops of three and hollows of four balls that have a common point: they are
///    holes in the axis where the solid has none. If the topology of the solid was preserved
///    (axis.solid) they stay as well. No triangle turns over or loses its area.
/// 3. If that does not reach the number, triangles may turn over; then loops and hollows are
///    closed, the cheapest first; last, whole components, each one ball by now, are left out, the
///    smallest ball first. Only then has the result fewer components than the union of balls.
/// 4. All balls are moved together, a little, until cones and wedges fit the boundary best (least
///    squares, a dozen Gauss-Newton steps). Cells stay as they are.
///
/// Balls and their radii fit the boundary in the mean: they may reach a little beyond it, but not
/// by more than a quarter of their radius, where the axis has closest points to tell.
///
/// SeparationAngle and the closest points of a ball are those of the point of `axis` next to it
/// among those that it stands for; lambda is its radius times the sine of half that angle. Arrays
/// that are empty in `axis` stay empty. Features are those of the new cells. Cells are triangles,
/// lines and vertices.
///
/// An axis with no more points than that is returned as it is. MedialAxis::simplification tells
/// what was done.
///
/// @throws Error InvalidInput for maxSpheres < 1, arrays or cells that do not fit the points, and
///   coordinates or radii that are not finite or negative; Cancelled.
MEDIAL_EXPORT MedialAxis simplifyAxis(const MedialAxis& axis,
  const SimplificationOptions& options = {});

} // namespace medial

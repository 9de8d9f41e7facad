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
  /// Maximum number of balls, that is of points, of the result; >= 1. A few hundred are usually
  /// enough to describe a shape; fewer make it rounder.
  std::int64_t maxSpheres = 200;
  Execution execution; ///< threads, progress and cancelling
};

/// Makes an axis compact: at most options.maxSpheres balls. The union of these balls, of the cones
/// between the two balls of a line (or of an edge of a triangle) and of the wedges between the
/// three of a triangle approximates the shape. The method is quadric edge collapse of the points
/// (x, y, z, radius) in R^4 (spherical quadrics: Thiery, Guy, Boubekeur, "Sphere-Meshes", 2013; of
/// wedges: Li, Wang, Sun, Guo, Zhang, Wang, "Q-MAT: Computing Medial Axis Transform by Quadratic
/// Error Minimization", 2015).
///
/// The steps, in this order:
/// 1. Quads become triangles. Components whose balls overlap are parts of one solid that the
///    selection has cut apart; a line between their nearest balls joins them.
/// 2. Edges are contracted, always the one that adds least to the squared distance between the
///    balls and the tangent planes of the boundary that they stand for. Components, loops and
///    hollows stay, except loops of three and hollows of four balls that have a common point: these
///    are holes in the axis where the solid has none. They stay too if the topology of the solid
///    was preserved (axis.solid). No triangle turns over or loses its area.
/// 3. If that is not enough, triangles may turn over. Then loops and hollows are closed, the
///    cheapest first. Finally whole components, each one ball by now, are left out, the smallest
///    ball first. Only in this case does the result have fewer components than the union of balls.
/// 4. All balls move together, a little, until cones and wedges fit the boundary best (least
///    squares, a dozen Gauss-Newton steps). Cells stay as they are.
///
/// Balls and their radii fit the boundary on average. They may extend a little beyond it, but by no
/// more than a quarter of their radius where the axis has closest points to compare with.
///
/// The separation angle and the closest pair of a ball come from the nearest of the points of
/// `axis` that it stands for; its lambda is its radius times the sine of half that angle. Arrays
/// that are empty in `axis` stay empty. Features are those of the new cells. Cells are triangles,
/// lines and vertices.
///
/// An axis with no more points than options.maxSpheres is returned unchanged.
/// MedialAxis::simplification tells what was done.
///
/// @throws Error InvalidInput for maxSpheres < 1, arrays or cells that do not fit the points,
///   coordinates that are not finite, and radii that are negative or not finite; Cancelled.
MEDIAL_EXPORT MedialAxis simplifyAxis(const MedialAxis& axis,
  const SimplificationOptions& options = {});

} // namespace medial

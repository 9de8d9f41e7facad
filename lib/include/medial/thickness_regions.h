#pragma once

#include "medial/execution.h"
#include "medial/export.h"
#include "medial/grid.h"
#include "medial/mesh_connectivity.h"
#include "medial/thickness.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// What thickness may be, world units, in (0, infinity).
struct ThicknessLimits
{
  std::optional<double> min; ///< places below it are too thin
  std::optional<double> max; ///< places above it are too thick
};

/// Neighbouring triangles whose thickness is beyond the same limit.
struct ThicknessRegion
{
  bool thin = true;                ///< too thin; otherwise too thick
  double area = 0.0;               ///< world units squared
  double value = 0.0;              ///< least thickness of a thin region, largest of a thick one
  Point3 place{};                  ///< where that is: a point of the mesh or a centre of a triangle
  std::vector<int> triangles;      ///< ids, ascending
  std::vector<std::int64_t> cells; ///< the input cells of these, ascending, each once
};

/// Checks limits.
/// @throws Error InvalidInput for a limit outside (0, infinity), a minimum that is not below the
///   maximum, and no limit at all.
MEDIAL_EXPORT void checkThicknessLimits(const ThicknessLimits& limits);

/// Checks that a mesh has an inside: it is closed, or has holes that SignMethod::Auto closes,
/// decided on a grid of 32 points. For any other mesh, the thickness of one side says nothing about
/// a solid.
/// @throws Error InvalidInput if not, with the reason; Cancelled.
MEDIAL_EXPORT void requireInside(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Execution& execution = {});

/// Finds where a solid is too thin or too thick. A triangle is beyond a limit if the thickness at
/// its centre is, by more than a millionth of the limit; triangles that share a point are one
/// region. So a place is found only if it holds centres of triangles: subdivide() a mesh whose
/// triangles are larger than the regions that matter. Places that are thin because of a convex edge
/// or tip (Thickness::atEdge), where every solid is, do not count.
///
/// @param thickness of the mesh, with values of its cells.
/// @return thin regions, the thinnest first, then thick ones, the thickest first.
/// @throws Error InvalidInput as checkThicknessLimits(), and for values of another number of points
///   or triangles than the mesh has.
MEDIAL_EXPORT std::vector<ThicknessRegion> findThicknessRegions(const TriangleMesh& mesh,
  const Thickness& thickness, const ThicknessLimits& limits);

} // namespace medial

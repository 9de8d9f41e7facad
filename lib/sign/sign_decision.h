#pragma once

#include "medial/error.h"
#include "medial/sign_method.h"
#include "sites/grid_frame.h"

#include <cstddef>
#include <cstdint>
#include <string>

// When Auto takes winding numbers, and how a sign is reported.
namespace medial
{

/// Winding numbers are asked for so far beside a point, local units: symmetric meshes have faces
/// and lids exactly through grid points, where rounding would decide, and not always alike.
inline const glm::dvec3 kBeside(1.1e-6, 1.7e-6, 2.3e-6);

/// Returns a grid whose points are beside those of another.
GridFrame besideGrid(GridFrame frame);

/// The reason for a method that was asked for, as it is reported.
std::string requestedReason(SignMethod requested);

/// The error of a surface that pseudonormals give no sign, by its edges.
Error noPseudonormals(std::int64_t boundary, std::int64_t nonManifold, std::int64_t misoriented);

/// Whether a surface is a soup of single triangles, which has no inside.
bool isTorn(std::int64_t rimEdges, std::size_t triangles);

/// The reason for no sign on a torn surface.
std::string tornReason(std::int64_t rimEdges);

/// Sets the method and the reason: winding numbers, or for Auto none where they tell nothing.
/// @param report has the holes and the shares of the surface.
void decideWinding(SignMethod requested, SignReport& report);

} // namespace medial

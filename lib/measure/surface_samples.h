#pragma once

#include "medial/triangle_mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// Returns the area of the triangles of a mesh, world units squared.
double surfaceArea(const TriangleMesh& mesh);

/// Spreads `count` points evenly by area over the triangles of a mesh; always the same ones.
std::vector<glm::dvec3> surfaceSamples(const TriangleMesh& mesh, std::int64_t count);

} // namespace medial

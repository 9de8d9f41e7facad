#pragma once

#include "medial/triangle_mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// World units squared; the triangles of a mesh only.
double surfaceArea(const TriangleMesh& mesh);

/// `count` points on the triangles of a mesh, evenly spread by area; always the same ones.
std::vector<glm::dvec3> surfaceSamples(const TriangleMesh& mesh, std::int64_t count);

} // namespace medial

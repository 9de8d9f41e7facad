#pragma once

#include "medial/triangle_mesh.h"

#include "support/named.h"

#include <cstddef>
#include <random>
#include <vector>

// Meshes whose inside is known, or known by winding numbers.
namespace medial::test
{

/// A mesh and closed meshes that face outwards: what is in one of them is inside.
struct Assembly
{
  TriangleMesh mesh;
  std::vector<TriangleMesh> parts;
};

/// Parts that overlap, touch or face different ways, and solids with some triangles turned round or
/// there twice.
std::vector<Named<Assembly>> assemblies();
/// Meshes with holes, and some without an inside.
std::vector<Named<TriangleMesh>> openMeshes();
/// A solid with random defects: triangles that are missing, turned round or there twice, and points
/// that are elsewhere, so that triangles cross each other or have no area.
TriangleMesh defective(std::mt19937& random);

TriangleMesh hemisphere();
TriangleMesh welded(const TriangleMesh& mesh);
TriangleMesh withoutTriangles(TriangleMesh mesh, const std::vector<std::size_t>& ascending);
TriangleMesh withFlipped(TriangleMesh mesh, const std::vector<std::size_t>& triangles);

} // namespace medial::test

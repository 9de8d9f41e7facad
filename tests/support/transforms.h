#pragma once

#include "medial/triangle_mesh.h"

#include <array>
#include <vector>

// Meshes made from lists and from other meshes.
namespace medial::test
{

/// The given cells through buildTriangleMesh; cell ids count triangles, segments, then vertices.
TriangleMesh makeMesh(const std::vector<Point3>& points,
  const std::vector<std::array<int, 3>>& triangles,
  const std::vector<std::array<int, 2>>& segments = {}, const std::vector<int>& vertices = {});

/// The mesh as buildTriangleMesh would receive it; cell ids are kept.
MeshInput toInput(const TriangleMesh& mesh);

/// As toInput, but no two cells share a point.
MeshInput unwelded(const TriangleMesh& mesh);

TriangleMesh translated(TriangleMesh mesh, const Point3& offset);

/// @param factor > 0.
TriangleMesh scaled(TriangleMesh mesh, double factor);

/// Turned about coordinate axis 0, 1 or 2 by an angle in radians, anticlockwise seen from its tip.
TriangleMesh turned(TriangleMesh mesh, int axis, double angle);

/// A quarter turn about coordinate axis 0, 1 or 2, anticlockwise seen from its tip; exact.
TriangleMesh rotated90(TriangleMesh mesh, int axis);

/// Negates a coordinate and flips the triangles, so that outwards stays outwards.
TriangleMesh mirrored(TriangleMesh mesh, int axis);

TriangleMesh flipOrientation(TriangleMesh mesh);

/// Every triangle cut into four at the middles of its edges, `times` times; the shape is the same.
TriangleMesh subdivided(TriangleMesh mesh, int times);

/// As files of CAD programs have them: at the places named, an edge has a further point, but only
/// the triangle on one side of it knows that; a triangle without area closes the gap.
/// @param places any number of them, chosen by a seed; later ones may lie on edges of such
/// triangles.
/// @param height of these triangles as a share of their length, in any direction.
TriangleMesh withFlatTriangles(const TriangleMesh& mesh, int places, double height,
  unsigned int seed);

/// Both meshes in one, bit-equal points welded; cell ids of `b` follow those of `a`.
TriangleMesh appended(const TriangleMesh& a, const TriangleMesh& b);

} // namespace medial::test

#pragma once

#include "medial/triangle_mesh.h"

#include <cstdint>

// Meshes whose sites are far smaller or far longer than a voxel. They are meant for grids of
// spacing 1, so lengths are in voxels. Random ones are the same for the same seed.
namespace medial::test
{

/// An icosphere at the origin whose points lie at random distances in
/// [1 - roughness, 1 + roughness] * radius from it, so that one triangle cannot pass for its
/// neighbour; closed and oriented outwards.
TriangleMesh roughSphere(double radius, int subdivisions, double roughness);

/// `count` triangles as long as `length` with a common corner at the origin, in a cone of half
/// angle 27 degrees about the x axis. The i-th is 10^-(i % 13) wide at its far end, so most have
/// hardly any area.
TriangleMesh needleFan(int count, double length);

/// A strip about the x axis, from 0 to `length`, of 2 * `pieces` triangles, which makes one turn.
TriangleMesh twistedStrip(int pieces, double length, double width);

/// Triangles without common points, at random places with |x|, |y|, |z| <= halfSide. Their sizes
/// are spread evenly in logarithms; every seventh has no area.
TriangleMesh scatteredTriangles(int count, double minSize, double maxSize, double halfSide,
  std::uint32_t seed = 1);

/// `count` segments of any length and as many vertices within |x|, |y|, |z| <= halfSide.
TriangleMesh scatteredSegmentsAndVertices(int count, double halfSide, std::uint32_t seed = 1);

} // namespace medial::test

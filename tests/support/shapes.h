#pragma once

#include "medial/triangle_mesh.h"
#include "support/transforms.h"

#include <cstdint>
#include <string>
#include <vector>

// Meshes whose distance fields and medial axes are known. Lengths are world units, angles degrees.
// Unless said otherwise shapes are centred at the origin, closed and oriented outwards, and the
// cell id of a triangle is its index.
namespace medial::test
{

/// Box |x| <= halfSides[0] and so on.
TriangleMesh box(const Point3& halfSides);

/// The square |x|, |y| <= halfSide without its quarter x, y > 0, over |z| <= halfHeight; its reflex
/// edge lies on the z axis.
TriangleMesh lPrism(double halfSide, double halfHeight);

/// Icosahedron with its edges halved `subdivisions` times (20 * 4^subdivisions triangles); points
/// lie on the sphere, faces inside by up to radius * 0.2 / 4^subdivisions.
TriangleMesh icosphere(double radius, int subdivisions);

/// Icosphere scaled to semi-axes a, b, c along x, y, z.
TriangleMesh ellipsoid(double a, double b, double c, int subdivisions);

/// Capsule about the segment |z| <= halfLength, `segments` (a multiple of 4) around.
TriangleMesh uvCapsule(double radius, double halfLength, int segments);

/// Torus about the z axis with tube radius rho: nu points along the circle of radius R, nv around
/// the tube.
TriangleMesh torus(double R, double rho, int nu, int nv);

/// Cylinder about the z axis, |z| <= height / 2, with n sides; the caps have a centre point.
TriangleMesh cylinder(double radius, double height, int n);

/// What lies between icospheres of radii inner < outer; the inner one faces the origin.
TriangleMesh shell(double inner, double outer, int subdivisions);

/// Two open squares |x|, |y| <= halfSide at z = +-gap / 2, facing away from each other.
TriangleMesh plates(double gap, double halfSide);

/// Prism over |z| <= length / 2 with an edge on the z axis whose two faces enclose `dihedral`, in
/// (0, 180) convex or in (180, 360) reflex, bisected by the plane y = 0, x > 0; they are `width`
/// wide.
TriangleMesh wedge(double dihedral, double length, double width);

/// Tetrahedron with edges of length `edge`.
TriangleMesh regularTetrahedron(double edge);

/// Blocks 1 wide, |z| <= halfHeight, where rows of text have a '#', the first row at the top and
/// the first block at the origin; blocks that share no face must not touch.
TriangleMesh blocks(const std::vector<std::string>& rows, double halfHeight);

/// An open tube with `sides` sides along the x axis, |x| <= halfLength, that is thinner than the
/// rounding of any local coordinates: triangles without area, whose long edges are equally long.
TriangleMesh hair(double halfLength, int sides);

/// n triangles without common points, corners uniformly random in [-1, 1]^3.
TriangleMesh randomSoup(int n, std::uint32_t seed);

} // namespace medial::test

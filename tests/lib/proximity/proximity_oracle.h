#pragma once

#include "medial/proximity.h"
#include "medial/triangle_mesh.h"
#include "support/mesh_search.h"

#include <vector>

// How two meshes of triangles with area lie to each other, by all pairs of their triangles. Shares
// no code with the library. What is exact needs meshes from snapped().
namespace medial::test
{

/// Rounds coordinates, which must be below 4, to multiples of 2^-38: products of three are exact in
/// integers then.
TriangleMesh snapped(TriangleMesh mesh);
Point3 snapped(Point3 point);

/// Whether any two triangles share a point. Exact.
bool surfacesIntersect(const TriangleMesh& a, const TriangleMesh& b);

/// Least distance of surfaces that do not intersect.
double surfaceSeparation(const TriangleMesh& a, const TriangleMesh& b);

/// The solid of a closed mesh whose triangles face outwards.
class SolidOracle
{
public:
  /// The mesh must outlive the oracle.
  explicit SolidOracle(const TriangleMesh& mesh);
  ~SolidOracle();

  /// The winding number around a point that is not on the mesh. Exact.
  int windingNumber(const Point3& point) const;
  bool contains(const Point3& point) const { return this->windingNumber(point) > 0; }
  /// Distance of any point to the surface.
  double distanceTo(const Point3& point) const { return search_.closest(point).distance; }
  /// The points of a mesh inside with their distances to the surface, by ascending id.
  std::vector<PointDepth> depthsOf(const TriangleMesh& mesh) const;
  /// The largest distance to the surface of a mesh's places inside, of many on every triangle.
  double sampledDepthOf(const TriangleMesh& mesh, int samplesPerSide) const;

private:
  struct Facet;

  MeshSearch search_;
  Bounds bounds_;
  std::vector<Facet> facets_;
};

/// How far A must move along a unit vector to leave a plane between it and B; 0 if there is one.
double widthAlong(const TriangleMesh& a, const TriangleMesh& b, const Point3& direction);

/// Length of the shortest translation that separates two convex meshes that overlap: the least
/// width along the normals of the Minkowski difference.
double convexTranslationalDepth(const TriangleMesh& a, const TriangleMesh& b);

} // namespace medial::test

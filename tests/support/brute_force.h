#pragma once

#include "medial/distance_field.h"
#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

// The oracle: exact answers in double precision that share no code with the library. Shapes may be
// slivers, have no area or lie far from the origin.
namespace medial::test
{

/// The closest point of a mesh, or of a part of it, to a query point.
struct Hit
{
  double distance = std::numeric_limits<double>::infinity(); ///< world units, >= 0
  Point3 point{};                                            ///< world coordinates
  Feature kind = Feature::Vertex; ///< what the point lies inside; at ties the lower one
};

/// The closer of two hits; at equal distance the one inside the simpler feature.
void keepCloser(Hit& best, const Hit& hit);

Hit closestOnSegment(const Point3& a, const Point3& b, const Point3& query);
Hit closestOnTriangle(const Point3& a, const Point3& b, const Point3& c, const Point3& query);

/// Closest point over all triangles, segments and vertices of a mesh.
Hit closestOnMesh(const TriangleMesh& mesh, const Point3& query);

/// Closest point over the segments and vertices of a mesh alone.
Hit closestOnSegmentsAndVertices(const TriangleMesh& mesh, const Point3& query);

/// As closestOnMesh for every query, on all cores; a MeshSearch saves most triangles.
std::vector<Hit> closestOnMesh(const TriangleMesh& mesh, const std::vector<Point3>& queries);

/// Closest point of a site taken as a closed set: face, edge or point, numbered in this order.
Hit closestOnSite(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  std::int64_t siteId, const Point3& query);
double distanceToSite(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  std::int64_t siteId, const Point3& query);

/// Distance to the elements made from one input cell; infinite if the mesh has none.
double distanceToCell(const TriangleMesh& mesh, std::int64_t cellId, const Point3& query);

/// Sum of the signed solid angles of the triangles over 4 pi: 1 inside a closed mesh oriented
/// outwards, 0 outside; undefined on the surface.
double windingNumber(const TriangleMesh& mesh, const Point3& query);

/// Every point of a grid, x fastest.
std::vector<Point3> gridPoints(const Grid& grid);

/// `count` points, uniformly random in a box; the same for the same seed.
std::vector<Point3> randomPoints(const Bounds& bounds, int count, std::uint32_t seed);

/// Calls body(i) for i in [0, count) on all cores, in any order.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

} // namespace medial::test

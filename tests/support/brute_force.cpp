#include "support/brute_force.h"

#include "support/mesh_search.h"
#include "support/point_math.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <thread>

namespace medial::test
{

namespace
{

Point3 operator+(const Point3& a, const Point3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Point3 operator-(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Point3 operator*(double factor, const Point3& a)
{
  return { factor * a[0], factor * a[1], factor * a[2] };
}

Hit closestOnPoint(const Point3& p, const Point3& query)
{
  return { length(query - p), p, Feature::Vertex };
}

/// Closest point of the triangle a, a + u, a + v with the longest edge u, if it lies inside. The
/// candidate is built from the edges and so lies on the triangle even if it is a sliver, where a
/// distance along a normal could be far too small.
Hit closestInside(const Point3& a, const Point3& u, const Point3& v, const Point3& query)
{
  const double along = dot(u, v) / dot(u, u);
  const Point3 height = v - along * u;
  const double heightSquared = dot(height, height);
  if (!(heightSquared > 0.0))
  {
    return {};
  }
  const Point3 q = query - a;
  const double t = dot(q, height) / heightSquared;
  const double s = dot(q, u) / dot(u, u) - t * along;
  if (s < 0.0 || t < 0.0 || s + t > 1.0)
  {
    return {};
  }
  const Point3 offset = s * u + t * v;
  return { length(q - offset), a + offset, Feature::Face };
}

Hit onTriangle(const std::array<int, 3>& t, const TriangleMesh& mesh, const Point3& query)
{
  return closestOnTriangle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], query);
}

Hit onSegment(const std::array<int, 2>& s, const TriangleMesh& mesh, const Point3& query)
{
  return closestOnSegment(mesh.points[s[0]], mesh.points[s[1]], query);
}

} // namespace

void keepCloser(Hit& best, const Hit& hit)
{
  if (hit.distance < best.distance || (hit.distance == best.distance && hit.kind < best.kind))
  {
    best = hit;
  }
}

Hit closestOnSegment(const Point3& a, const Point3& b, const Point3& query)
{
  const Point3 side = b - a;
  const double t = dot(query - a, side) / dot(side, side);
  if (!(t > 0.0))
  {
    return closestOnPoint(a, query);
  }
  if (t >= 1.0)
  {
    return closestOnPoint(b, query);
  }
  // Offsets relative to the nearer end lose less to rounding.
  const Point3 offset = t < 0.5 ? t * side : (t - 1.0) * side;
  const Point3& end = t < 0.5 ? a : b;
  return { length(query - end - offset), end + offset, Feature::Edge };
}

Hit closestOnTriangle(const Point3& a, const Point3& b, const Point3& c, const Point3& query)
{
  Hit best = closestOnSegment(a, b, query);
  keepCloser(best, closestOnSegment(b, c, query));
  keepCloser(best, closestOnSegment(c, a, query));
  const double ab = length(b - a);
  const double bc = length(c - b);
  const double ca = length(a - c);
  if (ab >= bc && ab >= ca)
  {
    keepCloser(best, closestInside(a, b - a, c - a, query));
  }
  else if (bc >= ca)
  {
    keepCloser(best, closestInside(b, c - b, a - b, query));
  }
  else
  {
    keepCloser(best, closestInside(c, a - c, b - c, query));
  }
  return best;
}

Hit closestOnSegmentsAndVertices(const TriangleMesh& mesh, const Point3& query)
{
  Hit best;
  for (const auto& segment : mesh.segments)
  {
    keepCloser(best, onSegment(segment, mesh, query));
  }
  for (const int vertex : mesh.vertices)
  {
    keepCloser(best, closestOnPoint(mesh.points[vertex], query));
  }
  return best;
}

Hit closestOnMesh(const TriangleMesh& mesh, const Point3& query)
{
  Hit best = closestOnSegmentsAndVertices(mesh, query);
  for (const auto& triangle : mesh.triangles)
  {
    keepCloser(best, onTriangle(triangle, mesh, query));
  }
  return best;
}

std::vector<Hit> closestOnMesh(const TriangleMesh& mesh, const std::vector<Point3>& queries)
{
  const MeshSearch search(mesh);
  std::vector<Hit> hits(queries.size());
  parallelFor(queries.size(), [&](std::size_t i) { hits[i] = search.closest(queries[i]); });
  return hits;
}

Hit closestOnSite(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  std::int64_t siteId, const Point3& query)
{
  const auto faces = static_cast<std::int64_t>(mesh.triangles.size());
  const auto edges = static_cast<std::int64_t>(connectivity.edges.size());
  if (siteId < faces)
  {
    return onTriangle(mesh.triangles.at(siteId), mesh, query);
  }
  if (siteId < faces + edges)
  {
    return onSegment(connectivity.edges[siteId - faces], mesh, query);
  }
  return closestOnPoint(mesh.points.at(siteId - faces - edges), query);
}

double distanceToSite(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  std::int64_t siteId, const Point3& query)
{
  return closestOnSite(mesh, connectivity, siteId, query).distance;
}

double distanceToCell(const TriangleMesh& mesh, std::int64_t cellId, const Point3& query)
{
  Hit best;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (mesh.triangleCells[i] == cellId)
    {
      keepCloser(best, onTriangle(mesh.triangles[i], mesh, query));
    }
  }
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
  {
    if (mesh.segmentCells[i] == cellId)
    {
      keepCloser(best, onSegment(mesh.segments[i], mesh, query));
    }
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
  {
    if (mesh.vertexCells[i] == cellId)
    {
      keepCloser(best, closestOnPoint(mesh.points[mesh.vertices[i]], query));
    }
  }
  return best.distance;
}

double windingNumber(const TriangleMesh& mesh, const Point3& query)
{
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
  {
    const Point3 a = mesh.points[t[0]] - query;
    const Point3 b = mesh.points[t[1]] - query;
    const Point3 c = mesh.points[t[2]] - query;
    const double la = length(a);
    const double lb = length(b);
    const double lc = length(c);
    // Van Oosterom and Strackee: the tangent of half the solid angle.
    sum += 2.0 *
      std::atan2(dot(a, cross(b, c)),
        la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4.0 * kPi);
}

std::vector<Point3> gridPoints(const Grid& grid)
{
  std::vector<Point3> points;
  points.reserve(grid.pointCount());
  for (int k = 0; k < grid.dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.dimensions[1]; ++j)
    {
      for (int i = 0; i < grid.dimensions[0]; ++i)
      {
        points.push_back(grid.point(i, j, k));
      }
    }
  }
  return points;
}

std::vector<Point3> randomPoints(const Bounds& bounds, int count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<Point3> points(count);
  for (Point3& point : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double share = (static_cast<double>(random()) + 0.5) / 4294967296.0;
      point[axis] = bounds.min[axis] + share * (bounds.max[axis] - bounds.min[axis]);
    }
  }
  return points;
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body)
{
  constexpr std::size_t kChunk = 64;
  std::atomic<std::size_t> next{ 0 };
  const auto work = [&]
  {
    for (std::size_t begin = next.fetch_add(kChunk); begin < count; begin = next.fetch_add(kChunk))
    {
      for (std::size_t i = begin; i < std::min(begin + kChunk, count); ++i)
      {
        body(i);
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
  {
    threads.emplace_back(work);
  }
  work();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

} // namespace medial::test

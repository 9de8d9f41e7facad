#include "lib/proximity/proximity_oracle.h"

#include "lib/proximity/integer_elements.h"
#include "support/point_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace medial::test
{
namespace
{

constexpr int kExponent = -38;

using Triangle = std::array<Point3, 3>;

Triangle triangleOf(const TriangleMesh& mesh, std::size_t id)
{
  const auto& [a, b, c] = mesh.triangles[id];
  return { mesh.points[a], mesh.points[b], mesh.points[c] };
}

IntegerVector integersOf(const Point3& p)
{
  return multiples({ p[0], p[1], p[2] }, kExponent);
}

Corners cornersOf(const Triangle& triangle)
{
  return { integersOf(triangle[0]), integersOf(triangle[1]), integersOf(triangle[2]) };
}

Bounds boundsOf(const Triangle& triangle)
{
  Bounds bounds{ triangle[0], triangle[0] };
  for (const Point3& p : triangle)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      bounds.min[axis] = std::min(bounds.min[axis], p[axis]);
      bounds.max[axis] = std::max(bounds.max[axis], p[axis]);
    }
  }
  return bounds;
}

std::vector<Bounds> boundsOfTriangles(const TriangleMesh& mesh)
{
  std::vector<Bounds> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    all.push_back(boundsOf(triangleOf(mesh, i)));
  }
  return all;
}

double squaredGap(const Bounds& a, const Bounds& b)
{
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double gap = std::max({ a.min[axis] - b.max[axis], b.min[axis] - a.max[axis], 0.0 });
    sum += gap * gap;
  }
  return sum;
}

bool isWithin(const Bounds& bounds, const Point3& p)
{
  return squaredGap(bounds, { p, p }) == 0.0;
}

/// Calls visit(i, k) for the pairs of triangles whose boxes are no farther apart than a limit,
/// until it returns true.
template <typename Limit, typename Visit>
bool anyPair(const TriangleMesh& a, const TriangleMesh& b, const Limit& squaredLimit,
  const Visit& visit)
{
  const std::vector<Bounds> boundsB = boundsOfTriangles(b);
  const Bounds wholeB = b.bounds();
  for (std::size_t i = 0; i < a.triangles.size(); ++i)
  {
    const Bounds boundsA = boundsOf(triangleOf(a, i));
    if (squaredGap(boundsA, wholeB) > squaredLimit())
    {
      continue;
    }
    for (std::size_t k = 0; k < boundsB.size(); ++k)
    {
      if (squaredGap(boundsA, boundsB[k]) <= squaredLimit() && visit(i, k))
      {
        return true;
      }
    }
  }
  return false;
}

/// The distance of the lines through two edges, where it is that of places within both; otherwise
/// infinite.
double distanceAcross(const Point3& p, const Point3& p2, const Point3& q, const Point3& q2)
{
  const Point3 u = minus(p2, p);
  const Point3 v = minus(q2, q);
  const Point3 w = minus(q, p);
  const Point3 normal = cross(u, v);
  const double squared = dot(normal, normal);
  const double s = dot(cross(w, v), normal) / squared;
  const double t = dot(cross(w, u), normal) / squared;
  const bool within = s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0; // false for parallel ones
  return within ? std::abs(dot(normal, w)) / std::sqrt(squared)
                : std::numeric_limits<double>::infinity();
}

double triangleDistance(const Triangle& a, const Triangle& b)
{
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    best = std::min(best, closestOnTriangle(b[0], b[1], b[2], a[i]).distance);
    best = std::min(best, closestOnTriangle(a[0], a[1], a[2], b[i]).distance);
    for (std::size_t k = 0; k < 3; ++k)
    {
      best = std::min(best, distanceAcross(a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3]));
    }
  }
  return best;
}

/// Twice the signed area of abp seen along z, p moved by an infinitely small step (e, e * e).
int sideSeenFromAbove(const IntegerVector& a, const IntegerVector& b, const IntegerVector& p)
{
  const IntegerVector edge = difference(b, a);
  const IntegerVector toPoint = difference(p, a);
  const int side = signOf(edge[0] * toPoint[1] - edge[1] * toPoint[0]);
  const int ofStep = edge[1] != 0 ? -signOf(edge[1]) : signOf(edge[0]);
  return side != 0 ? side : ofStep;
}

/// 1 or -1 if the ray from a point along z leaves or enters through a triangle.
int passageAbove(const Corners& corners, const IntegerVector& point)
{
  const auto& [a, b, c] = corners;
  const int side = sideSeenFromAbove(a, b, point);
  if (side != sideSeenFromAbove(b, c, point) || side != sideSeenFromAbove(c, a, point))
  {
    return 0;
  }
  return exactSide(a, b, c, point) == side ? side : 0;
}

/// A lattice of places on a triangle.
std::vector<Point3> samplesOf(const Triangle& triangle, int samplesPerSide)
{
  const auto& [a, b, c] = triangle;
  std::vector<Point3> samples;
  for (int i = 0; i <= samplesPerSide; ++i)
  {
    for (int k = 0; i + k <= samplesPerSide; ++k)
    {
      const double s = static_cast<double>(i) / samplesPerSide;
      const double t = static_cast<double>(k) / samplesPerSide;
      Point3& sample = samples.emplace_back();
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        sample[axis] = a[axis] + s * (b[axis] - a[axis]) + t * (c[axis] - a[axis]);
      }
      sample = snapped(sample);
    }
  }
  return samples;
}

/// Normals of the triangles, of any length.
std::vector<Point3> normalsOf(const TriangleMesh& mesh)
{
  std::vector<Point3> normals;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto [a, b, c] = triangleOf(mesh, i);
    normals.push_back(cross(minus(b, a), minus(c, a)));
  }
  return normals;
}

std::vector<Point3> edgesOf(const TriangleMesh& mesh)
{
  std::set<std::pair<int, int>> edges;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    edges.insert({ std::minmax(a, b), std::minmax(b, c), std::minmax(c, a) });
  }
  std::vector<Point3> vectors;
  for (const auto& [a, b] : edges)
  {
    vectors.push_back(minus(mesh.points[b], mesh.points[a]));
  }
  return vectors;
}

} // namespace

TriangleMesh snapped(TriangleMesh mesh)
{
  for (Point3& point : mesh.points)
  {
    point = snapped(point);
  }
  return mesh;
}

Point3 snapped(Point3 point)
{
  for (double& x : point)
  {
    x = std::ldexp(std::nearbyint(std::ldexp(x, -kExponent)), kExponent);
  }
  return point;
}

bool surfacesIntersect(const TriangleMesh& a, const TriangleMesh& b)
{
  return anyPair(
    a, b, [] { return 0.0; },
    [&](std::size_t i, std::size_t k)
    { return !areApart(cornersOf(triangleOf(a, i)), cornersOf(triangleOf(b, k))); });
}

double surfaceSeparation(const TriangleMesh& a, const TriangleMesh& b)
{
  const MeshSearch searchB(b);
  double best = std::numeric_limits<double>::infinity();
  for (const Point3& point : a.points)
  {
    best = std::min(best, searchB.closest(point).distance);
  }
  anyPair(
    a, b, [&] { return best * best * (1.0 + 1e-9); },
    [&](std::size_t i, std::size_t k)
    {
      best = std::min(best, triangleDistance(triangleOf(a, i), triangleOf(b, k)));
      return false;
    });
  return best;
}

struct SolidOracle::Facet
{
  Bounds bounds;
  Corners corners;
};

SolidOracle::SolidOracle(const TriangleMesh& mesh)
  : search_(mesh)
  , bounds_(mesh.bounds())
{
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const Triangle triangle = triangleOf(mesh, i);
    facets_.push_back({ boundsOf(triangle), cornersOf(triangle) });
  }
}

SolidOracle::~SolidOracle() = default;

int SolidOracle::windingNumber(const Point3& point) const
{
  int sum = 0;
  if (!isWithin(bounds_, point))
  {
    return sum;
  }
  const IntegerVector exact = integersOf(point);
  for (const Facet& facet : facets_)
  {
    const auto& [min, max] = facet.bounds;
    if (min[0] <= point[0] && point[0] <= max[0] && min[1] <= point[1] && point[1] <= max[1] &&
      point[2] <= max[2])
    {
      sum += passageAbove(facet.corners, exact);
    }
  }
  return sum;
}

std::vector<PointDepth> SolidOracle::depthsOf(const TriangleMesh& mesh) const
{
  std::vector<PointDepth> depths;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    if (this->contains(mesh.points[i]))
    {
      depths.push_back({ static_cast<int>(i), this->distanceTo(mesh.points[i]) });
    }
  }
  return depths;
}

double SolidOracle::sampledDepthOf(const TriangleMesh& mesh, int samplesPerSide) const
{
  double deepest = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const Triangle triangle = triangleOf(mesh, i);
    if (squaredGap(boundsOf(triangle), bounds_) > 0.0)
    {
      continue;
    }
    for (const Point3& sample : samplesOf(triangle, samplesPerSide))
    {
      if (this->contains(sample))
      {
        deepest = std::max(deepest, this->distanceTo(sample));
      }
    }
  }
  return deepest;
}

double widthAlong(const TriangleMesh& a, const TriangleMesh& b, const Point3& direction)
{
  double lowestOfA = std::numeric_limits<double>::infinity();
  double highestOfB = -std::numeric_limits<double>::infinity();
  for (const Point3& point : a.points)
  {
    lowestOfA = std::min(lowestOfA, dot(point, direction));
  }
  for (const Point3& point : b.points)
  {
    highestOfB = std::max(highestOfB, dot(point, direction));
  }
  return std::max(0.0, highestOfB - lowestOfA);
}

double convexTranslationalDepth(const TriangleMesh& a, const TriangleMesh& b)
{
  std::vector<Point3> directions = normalsOf(a);
  const std::vector<Point3> ofB = normalsOf(b);
  directions.insert(directions.end(), ofB.begin(), ofB.end());
  const std::vector<Point3> edgesOfB = edgesOf(b);
  for (const Point3& edge : edgesOf(a))
  {
    for (const Point3& other : edgesOfB)
    {
      directions.push_back(cross(edge, other));
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Point3& direction : directions)
  {
    // Products of edges that are parallel up to rounding say nothing.
    if (length(direction) > 1e-9)
    {
      const double scale = 1.0 / length(direction);
      const Point3 unit{ scale * direction[0], scale * direction[1], scale * direction[2] };
      least = std::min(least, std::min(widthAlong(a, b, unit), widthAlong(b, a, unit)));
    }
  }
  return least;
}

} // namespace medial::test

#include "oracle.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial::benchmark
{
namespace
{

Point3 minus(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point3 cross(const Point3& a, const Point3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double length(const Point3& a)
{
  return std::sqrt(dot(a, a));
}

double distanceToSegment(const Point3& query, const Point3& a, const Point3& b)
{
  const Point3 along = minus(b, a);
  const Point3 offset = minus(query, a);
  const double squared = dot(along, along);
  const double t = squared > 0.0 ? std::clamp(dot(offset, along) / squared, 0.0, 1.0) : 0.0;
  return length({ offset[0] - t * along[0], offset[1] - t * along[1], offset[2] - t * along[2] });
}

/// Whether the projection of a point onto the plane of abc is inside its edge ab.
bool insideSide(const Point3& query, const Point3& a, const Point3& b, const Point3& normal)
{
  return dot(cross(normal, minus(b, a)), minus(query, a)) > 0.0;
}

double distanceToCorners(const Point3& query, const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 normal = cross(minus(b, a), minus(c, a));
  const double area = length(normal);
  if (area > 0.0 && insideSide(query, a, b, normal) && insideSide(query, b, c, normal) &&
    insideSide(query, c, a, normal))
  {
    return std::abs(dot(normal, minus(query, a))) / area;
  }
  return std::min({ distanceToSegment(query, a, b), distanceToSegment(query, b, c),
    distanceToSegment(query, c, a) });
}

} // namespace

Oracle::Oracle(const TriangleMesh& mesh)
  : mesh_(mesh)
{
  for (const auto& triangle : mesh.triangles)
  {
    Sphere sphere{};
    for (const int corner : triangle)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        sphere.centre[axis] += mesh.points[corner][axis] / 3.0;
      }
    }
    for (const int corner : triangle)
    {
      sphere.radius = std::max(sphere.radius, length(minus(mesh.points[corner], sphere.centre)));
    }
    spheres_.push_back(sphere);
  }
}

double Oracle::distanceToTriangle(const Point3& query, std::int32_t triangle) const
{
  const auto& corners = mesh_.triangles[static_cast<std::size_t>(triangle)];
  return distanceToCorners(query, mesh_.points[corners[0]], mesh_.points[corners[1]],
    mesh_.points[corners[2]]);
}

double Oracle::distance(const Point3& query) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Sphere& sphere : spheres_)
  {
    nearest = std::min(nearest, length(minus(sphere.centre, query)) + sphere.radius);
  }
  for (std::size_t i = 0; i < spheres_.size(); ++i)
  {
    if (length(minus(spheres_[i].centre, query)) - spheres_[i].radius <= nearest)
    {
      nearest = std::min(nearest, this->distanceToTriangle(query, static_cast<std::int32_t>(i)));
    }
  }
  return nearest;
}

std::vector<double> Oracle::distances(const std::vector<Point3>& queries) const
{
  std::vector<double> result(queries.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, queries.size(), 8),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
      {
        result[i] = this->distance(queries[i]);
      }
    });
  return result;
}

} // namespace medial::benchmark

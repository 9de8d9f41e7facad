#include "support/thickness_oracle.h"

#include "support/brute_force.h"

#include <cmath>
#include <limits>

namespace medial::test
{

namespace
{

const double kDegree = std::acos(-1.0) / 180.0;

Point3 minus(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const Point3& a)
{
  return std::sqrt(dot(a, a));
}

Point3 cross(const Point3& a, const Point3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double angleBetween(const Point3& a, const Point3& b)
{
  return std::atan2(length(cross(a, b)), dot(a, b));
}

void scale(Point3& a, double factor)
{
  for (double& coordinate : a)
  {
    coordinate *= factor;
  }
}

/// A place on a ray and its closest point.
struct Place
{
  double distance;
  bool wide;
};

Place placeAt(const TriangleMesh& mesh, const Point3& start, const Point3& direction, double t,
  double angle)
{
  Point3 x = start;
  for (int axis = 0; axis < 3; ++axis)
  {
    x[axis] += t * direction[axis];
  }
  const Hit hit = closestOnMesh(mesh, x);
  const Point3 back{ -direction[0], -direction[1], -direction[2] };
  return { hit.distance, angleBetween(back, minus(hit.point, x)) >= angle * kDegree };
}

} // namespace

std::vector<Point3> pointNormals(const TriangleMesh& mesh)
{
  std::vector<Point3> normals(mesh.points.size(), Point3{});
  for (const auto& triangle : mesh.triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Point3& p = mesh.points[triangle[corner]];
      const Point3 u = minus(mesh.points[triangle[(corner + 1) % 3]], p);
      const Point3 v = minus(mesh.points[triangle[(corner + 2) % 3]], p);
      const Point3 normal = cross(u, v);
      const double area = length(normal);
      for (int axis = 0; axis < 3 && area > 0.0; ++axis)
      {
        normals[triangle[corner]][axis] += normal[axis] / area * angleBetween(u, v);
      }
    }
  }
  for (Point3& normal : normals)
  {
    const double size = length(normal);
    scale(normal, size > 1e-9 ? 1.0 / size : 0.0);
  }
  return normals;
}

double thicknessByBruteForce(const TriangleMesh& mesh, const Point3& start, const Point3& direction,
  double angle, double firstStep)
{
  constexpr double kGrowth = 1.01;
  constexpr int kBisections = 50;
  const double end = mesh.bounds().diagonal() / std::sin(std::min(angle, 90.0) * kDegree);
  double low = 0.0;
  double high = firstStep;
  while (!placeAt(mesh, start, direction, high, angle).wide)
  {
    low = high;
    high *= kGrowth;
    if (low > end)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }
  for (int i = 0; i < kBisections; ++i)
  {
    const double middle = 0.5 * (low + high);
    (placeAt(mesh, start, direction, middle, angle).wide ? high : low) = middle;
  }
  return 2.0 * placeAt(mesh, start, direction, high, angle).distance;
}

} // namespace medial::test

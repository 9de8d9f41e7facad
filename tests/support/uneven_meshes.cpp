#include "support/uneven_meshes.h"

#include "support/brute_force.h"
#include "support/point_math.h"
#include "support/shapes.h"

#include <array>
#include <cmath>
#include <vector>

namespace medial::test
{

namespace
{

Bounds cubeAround(double halfSide)
{
  return { { -halfSide, -halfSide, -halfSide }, { halfSide, halfSide, halfSide } };
}

/// Random numbers in (0, 1), three at a time.
std::vector<Point3> randomShares(int count, std::uint32_t seed)
{
  return randomPoints({ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } }, count, seed);
}

Point3 added(const Point3& a, const Point3& b, double factor)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

} // namespace

TriangleMesh roughSphere(double radius, int subdivisions, double roughness)
{
  TriangleMesh mesh = icosphere(radius, subdivisions);
  const std::vector<Point3> shares = randomShares(static_cast<int>(mesh.points.size()), 1);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    mesh.points[i] = added({}, mesh.points[i], 1.0 + roughness * (2.0 * shares[i][0] - 1.0));
  }
  return mesh;
}

TriangleMesh needleFan(int count, double length)
{
  std::vector<Point3> points{ {} };
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < count; ++i)
  {
    // The golden angle spreads them evenly.
    const double angle = 2.39996 * i;
    const double slope = 0.5 * std::sqrt((i + 0.5) / count);
    const double width = std::pow(10.0, -(i % 13));
    const Point3 tip{ length, length * slope * std::cos(angle), length * slope * std::sin(angle) };
    points.push_back(tip);
    points.push_back(added(tip, { 0.0, -std::sin(angle), std::cos(angle) }, width));
    triangles.push_back({ 0, 2 * i + 1, 2 * i + 2 });
  }
  return makeMesh(points, triangles);
}

TriangleMesh twistedStrip(int pieces, double length, double width)
{
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i <= pieces; ++i)
  {
    const double angle = 2.0 * kPi * i / pieces + 0.3;
    const double y = 0.5 * width * std::cos(angle);
    const double z = 0.5 * width * std::sin(angle);
    points.push_back({ length * i / pieces, y, z });
    points.push_back({ length * i / pieces, -y, -z });
    if (i > 0)
    {
      const int n = 2 * i;
      triangles.push_back({ n - 2, n - 1, n });
      triangles.push_back({ n - 1, n + 1, n });
    }
  }
  return makeMesh(points, triangles);
}

TriangleMesh scatteredTriangles(int count, double minSize, double maxSize, double halfSide,
  std::uint32_t seed)
{
  const std::vector<Point3> centres = randomPoints(cubeAround(halfSide), count, seed);
  const std::vector<Point3> offsets = randomPoints(cubeAround(0.5), 3 * count, seed + 1);
  const std::vector<Point3> shares = randomShares(count, seed + 2);
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < count; ++i)
  {
    const double size = minSize * std::pow(maxSize / minSize, shares[i][0]);
    for (int corner = 0; corner < 3; ++corner)
    {
      points.push_back(added(centres[i], offsets[3 * i + corner], size));
    }
    const int n = 3 * i;
    if (i % 7 == 6)
    {
      const Point3 along = added(points[n + 1], points[n], -1.0);
      points[n + 2] = added(points[n], along, shares[i][1]);
    }
    triangles.push_back({ n, n + 1, n + 2 });
  }
  return makeMesh(points, triangles);
}

TriangleMesh scatteredSegmentsAndVertices(int count, double halfSide, std::uint32_t seed)
{
  const std::vector<Point3> points = randomPoints(cubeAround(halfSide), 3 * count, seed);
  std::vector<std::array<int, 2>> segments;
  std::vector<int> vertices;
  for (int i = 0; i < count; ++i)
  {
    segments.push_back({ 3 * i, 3 * i + 1 });
    vertices.push_back(3 * i + 2);
  }
  return makeMesh(points, {}, segments, vertices);
}

} // namespace medial::test

#include "support/thickness_shapes.h"

#include "support/shapes.h"

#include <cmath>

namespace medial::test
{

TriangleMesh tube(double inner, double outer, double height, int n)
{
  constexpr int kRings = 16;
  const double pi = std::acos(-1.0);
  std::vector<Point3> points;
  // Up along the outer wall, down along the inner one.
  for (int ring = 0; ring < 2 * (kRings + 1); ++ring)
  {
    const bool up = ring <= kRings;
    const int step = up ? ring : 2 * kRings + 1 - ring;
    const double z = height * (static_cast<double>(step) / kRings - 0.5);
    for (int i = 0; i < n; ++i)
    {
      const double turn = 2.0 * pi * i / n;
      const double radius = up ? outer : inner;
      points.push_back({ radius * std::cos(turn), radius * std::sin(turn), z });
    }
  }
  std::vector<std::array<int, 3>> triangles;
  const int rings = 2 * (kRings + 1);
  for (int ring = 0; ring < rings; ++ring)
  {
    const int low = ring * n;
    const int high = (ring + 1) % rings * n;
    for (int i = 0; i < n; ++i)
    {
      const int j = (i + 1) % n;
      triangles.push_back({ low + i, low + j, high + j });
      triangles.push_back({ low + i, high + j, high + i });
    }
  }
  return makeMesh(points, triangles);
}

TriangleMesh prism(const std::vector<std::array<double, 2>>& corners, double halfHeight)
{
  const int n = static_cast<int>(corners.size());
  std::vector<Point3> points;
  for (const double z : { -halfHeight, halfHeight })
  {
    for (const auto& corner : corners)
    {
      points.push_back({ corner[0], corner[1], z });
    }
  }
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < n; ++i)
  {
    const int j = (i + 1) % n;
    triangles.push_back({ i, j, n + j });
    triangles.push_back({ i, n + j, n + i });
    if (i > 0 && j > 0)
    {
      triangles.push_back({ 0, j, i });
      triangles.push_back({ n, n + i, n + j });
    }
  }
  return makeMesh(points, triangles);
}

} // namespace medial::test

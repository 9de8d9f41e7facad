#include "support/bordered_shapes.h"

#include "support/medial_truth.h"
#include "support/shapes.h"

#include <cmath>
#include <vector>

namespace medial::test
{

TriangleMesh Ellipsoid::mesh(int subdivisions)
{
  return ellipsoid(1.0, 0.8, kC, subdivisions);
}

std::array<double, 2> Ellipsoid::border(double angle)
{
  const double ratio = kC / std::cos(0.5 * angle * std::acos(-1.0) / 180.0);
  const auto half = [&](double square)
  { return std::sqrt(1.0 / (ratio * ratio / (square * square) + 1.0 / square)); };
  return { half(kA2), half(kB2) };
}

double Ellipsoid::offBorder(const Point3& p, const std::array<double, 2>& half)
{
  const double x = p[0] / (half[0] * half[0]);
  const double y = p[1] / (half[1] * half[1]);
  return std::abs(x * p[0] + y * p[1] - 1.0) / (2.0 * std::hypot(x, y));
}

TriangleMesh roundedPlate(double halfLength, double halfWidth, double radius, int subdivisions)
{
  const TriangleMesh ball = icosphere(radius, subdivisions);
  std::vector<Point3> points;
  for (Point3 p : ball.points)
  {
    p = tilted(p);
    p[0] += p[0] > 0.0 ? halfLength : -halfLength;
    p[1] += p[1] > 0.0 ? halfWidth : -halfWidth;
    points.push_back(p);
  }
  return makeMesh(points, ball.triangles);
}

double boxAxisArea(double a, double b, double c)
{
  return 4.0 * (a - c) * (b - c) + 4.0 * std::sqrt(2.0) * (2.0 * a * c + 2.0 * b * c - c * c);
}

} // namespace medial::test

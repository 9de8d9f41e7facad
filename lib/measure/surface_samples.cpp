#include "measure/surface_samples.h"

#include "base/vectors.h"
#include "measure/low_discrepancy.h"

#include <cmath>

namespace medial
{
namespace
{

struct Corners
{
  glm::dvec3 a;
  glm::dvec3 b;
  glm::dvec3 c;

  Corners(const TriangleMesh& mesh, const std::array<int, 3>& triangle)
    : a(toVector(mesh.points[triangle[0]]))
    , b(toVector(mesh.points[triangle[1]]))
    , c(toVector(mesh.points[triangle[2]]))
  {
  }

  double area() const { return 0.5 * glm::length(glm::cross(b - a, c - a)); }
};

} // namespace

double surfaceArea(const TriangleMesh& mesh)
{
  double total = 0.0;
  for (const auto& triangle : mesh.triangles)
  {
    total += Corners(mesh, triangle).area();
  }
  return total;
}

std::vector<glm::dvec3> surfaceSamples(const TriangleMesh& mesh, std::int64_t count)
{
  std::vector<glm::dvec3> samples;
  samples.reserve(static_cast<std::size_t>(count));
  const double perArea = static_cast<double>(count) / surfaceArea(mesh);
  double start = 0.0;
  for (const auto& triangle : mesh.triangles)
  {
    const Corners corners(mesh, triangle);
    const double length = corners.area() * perArea;
    forEachSample(start, length,
      [&](const SquarePoint& at)
      { samples.push_back(pointInTriangle(corners.a, corners.b, corners.c, at)); });
    start += length;
  }
  return samples;
}

} // namespace medial

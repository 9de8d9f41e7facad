#include "measure/surface_samples.h"

#include "base/vectors.h"
#include "measure/low_discrepancy.h"

#include <array>

namespace medial
{
namespace
{

SurfaceTriangle triangleOf(const TriangleMesh& mesh, const std::array<int, 3>& corners)
{
  return { toVector(mesh.points[corners[0]]), toVector(mesh.points[corners[1]]),
    toVector(mesh.points[corners[2]]) };
}

} // namespace

void SurfaceTriangle::addSamples(double start, double length,
  std::vector<glm::dvec3>& samples) const
{
  forEachSample(start, length,
    [&](const SquarePoint& at) { samples.push_back(pointInTriangle(a, b, c, at)); });
}

double surfaceArea(const TriangleMesh& mesh)
{
  double total = 0.0;
  for (const auto& corners : mesh.triangles)
  {
    total += triangleOf(mesh, corners).area();
  }
  return total;
}

std::vector<glm::dvec3> surfaceSamples(const TriangleMesh& mesh, std::int64_t count)
{
  std::vector<glm::dvec3> samples;
  samples.reserve(static_cast<std::size_t>(count));
  const double perArea = static_cast<double>(count) / surfaceArea(mesh);
  double start = 0.0;
  for (const auto& corners : mesh.triangles)
  {
    const SurfaceTriangle triangle = triangleOf(mesh, corners);
    const double length = triangle.area() * perArea;
    triangle.addSamples(start, length, samples);
    start += length;
  }
  return samples;
}

} // namespace medial

#pragma once

#include "medial/triangle_mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// The corners of a triangle of a surface.
struct SurfaceTriangle
{
  glm::dvec3 a;
  glm::dvec3 b;
  glm::dvec3 c;

  double area() const { return 0.5 * glm::length(glm::cross(b - a, c - a)); }
  /// Appends the samples of the triangle.
  /// @param start, length of its piece of the line of all triangles.
  void addSamples(double start, double length, std::vector<glm::dvec3>& samples) const;
};

/// Returns the area of the triangles of a mesh, world units squared.
double surfaceArea(const TriangleMesh& mesh);

/// Spreads `count` points evenly by area over the triangles of a mesh; always the same ones.
std::vector<glm::dvec3> surfaceSamples(const TriangleMesh& mesh, std::int64_t count);

} // namespace medial

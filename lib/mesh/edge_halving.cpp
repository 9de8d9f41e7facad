#include "mesh/edge_halving.h"

#include "base/range_check.h"
#include "base/vectors.h"
#include "medial/error.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace medial
{
namespace
{

constexpr std::size_t kMaxTriangles = 100000000;

double lengthOf(const TriangleMesh& mesh, int a, int b)
{
  return glm::distance(toVector(mesh.points[a]), toVector(mesh.points[b]));
}

/// Appends the triangles into which the middles of its sides cut a triangle.
/// @return whether there is a middle.
bool split(const std::array<int, 3>& corners, const std::array<int, 3>& middles, TriangleMesh& mesh)
{
  const auto add = [&](int a, int b, int c) { mesh.triangles.push_back({ a, b, c }); };
  int first = 0; // a long edge after a short one, if both are there
  int count = 0;
  for (int side = 0; side < 3; ++side)
  {
    count += middles[side] >= 0 ? 1 : 0;
    first = middles[side] >= 0 && middles[(side + 2) % 3] < 0 ? side : first;
  }
  const int a = corners[first];
  const int b = corners[(first + 1) % 3];
  const int c = corners[(first + 2) % 3];
  const int ab = middles[first];
  const int bc = middles[(first + 1) % 3];
  const int ca = middles[(first + 2) % 3];
  switch (count)
  {
    case 0:
      add(a, b, c);
      break;
    case 1:
      add(a, ab, c);
      add(ab, b, c);
      break;
    case 2:
      add(ab, b, bc);
      // The shorter diagonal of what is left.
      if (lengthOf(mesh, a, bc) <= lengthOf(mesh, ab, c))
      {
        add(a, ab, bc);
        add(a, bc, c);
      }
      else
      {
        add(a, ab, c);
        add(ab, bc, c);
      }
      break;
    default:
      add(a, ab, ca);
      add(ab, b, bc);
      add(ca, bc, c);
      add(ab, bc, ca);
      break;
  }
  return count > 0;
}

} // namespace

void requireMaxEdge(double maxEdge)
{
  if (!(maxEdge > 0.0 && std::isfinite(maxEdge)))
  {
    throwOutside("maximum edge length", maxEdge, "(0, infinity)");
  }
}

/// Each has at most half the square of its edges as area.
double trianglesNeeded(const TriangleMesh& mesh, double maxEdge)
{
  double triangles = 0.0;
  for (const auto& corners : mesh.triangles)
  {
    const glm::dvec3 a = toVector(mesh.points[corners[0]]);
    const glm::dvec3 u = toVector(mesh.points[corners[1]]) - a;
    const glm::dvec3 v = toVector(mesh.points[corners[2]]) - a;
    triangles += std::max(1.0, glm::length(glm::cross(u, v)) / (maxEdge * maxEdge));
  }
  return triangles;
}

void requireFew(double triangles, double maxEdge)
{
  if (triangles > static_cast<double>(kMaxTriangles))
  {
    std::ostringstream text;
    text << "edges of at most " << maxEdge << " need more than " << kMaxTriangles << " triangles";
    throw Error(ErrorCode::InvalidInput, text.str());
  }
}

bool isLong(const TriangleMesh& mesh, int a, int b, double maxEdge)
{
  return lengthOf(mesh, a, b) > maxEdge;
}

Point3 middleOf(const TriangleMesh& mesh, int a, int b)
{
  return toPoint(0.5 * (toVector(mesh.points[a]) + toVector(mesh.points[b])));
}

bool splitTriangles(const std::vector<std::array<int, 3>>& middles, const Checkpoint& checkpoint,
  TriangleMesh& mesh)
{
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::int64_t> cells;
  triangles.swap(mesh.triangles);
  cells.swap(mesh.triangleCells);
  bool changed = false;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    checkpoint(i);
    changed = split(triangles[i], middles[i], mesh) || changed;
    mesh.triangleCells.resize(mesh.triangles.size(), cells[i]);
  }
  return changed;
}

} // namespace medial

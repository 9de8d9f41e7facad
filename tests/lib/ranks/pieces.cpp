#include "pieces.h"

#include "medial/triangle_mesh.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace medial::test
{
SurfacePiece pieceOf(const TriangleMesh& mesh, int rank, const Distribution& rankOf)
{
  SurfacePiece piece;
  std::map<int, int> points;
  const auto local = [&](int point)
  {
    const auto [found, isNew] = points.insert({ point, static_cast<int>(points.size()) });
    if (isNew)
    {
      piece.mesh.points.push_back(mesh.points[point]);
      piece.pointOrder.push_back(point);
    }
    return found->second;
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (rankOf(i) == rank)
    {
      const auto& [a, b, c] = mesh.triangles[i];
      // In an order of their own.
      const int last = local(c);
      piece.mesh.triangles.push_back({ local(a), local(b), last });
      piece.mesh.triangleCells.push_back(static_cast<std::int64_t>(i));
    }
  }
  return piece;
}

TriangleMesh numbered(TriangleMesh mesh)
{
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    mesh.triangleCells[i] = static_cast<std::int64_t>(i);
  }
  return mesh;
}

Distribution atRandom(int ranks)
{
  return [ranks](std::size_t triangle)
  { return static_cast<int>((triangle * 2654435761U >> 7U) % static_cast<unsigned>(ranks)); };
}

Distribution onTheLast(int ranks)
{
  return [ranks](std::size_t) { return ranks - 1; };
}

Distribution inRows(int ranks, std::size_t triangles)
{
  return [=](std::size_t triangle) { return static_cast<int>(triangle * ranks / triangles); };
}

TriangleMesh withoutLoosePoints(const TriangleMesh& mesh)
{
  TriangleMesh result;
  std::map<int, int> kept;
  for (const auto& triangle : mesh.triangles)
  {
    for (const int corner : triangle)
    {
      kept.insert({ corner, 0 });
    }
  }
  for (auto& [point, number] : kept)
  {
    number = static_cast<int>(result.points.size());
    result.points.push_back(mesh.points[point]);
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    result.triangles.push_back({ kept[a], kept[b], kept[c] });
  }
  result.triangleCells.resize(result.triangles.size());
  return result;
}

TriangleMesh torusAndBox()
{
  return numbered(appended(translated(torus(0.8, 0.23, 60, 30), { 0.11, 0.03, -0.21 }),
    translated(box({ 0.21, 0.33, 0.17 }), { 0.07, -0.05, 0.53 })));
}

TriangleMesh damagedSolids(unsigned seed)
{
  const TriangleMesh sound =
    appended(appended(appended(box({ 1.5, 1.1, 0.9 }), flipOrientation(icosphere(0.6, 2))),
               appended(translated(torus(0.25, 0.08, 12, 8), { 0.1, 0.0, 0.0 }),
                 translated(icosphere(0.3, 1), { 1.1, 0.6, 0.3 }))),
      appended(translated(regularTetrahedron(0.3), { -1.0, 0.2, 0.1 }),
        translated(box({ 0.2, 0.2, 0.2 }), { 1.7, 0.0, 0.0 })));
  TriangleMesh mesh;
  mesh.points = sound.points;
  std::mt19937 random(seed);
  const auto oneIn = [&](unsigned count) { return random() % count == 0; };
  for (std::array<int, 3> triangle : sound.triangles)
  {
    if (oneIn(25))
    {
      std::swap(triangle[0], triangle[1]);
    }
    if (!oneIn(40))
    {
      mesh.triangles.push_back(triangle);
    }
    if (oneIn(30))
    {
      mesh.triangles.push_back({ triangle[1], triangle[0], triangle[2] });
    }
    if (oneIn(60))
    {
      // A fin at an edge.
      const Point3& a = mesh.points[triangle[0]];
      mesh.points.push_back({ 1.1 * a[0], 1.1 * a[1], 1.1 * a[2] + 0.05 });
      mesh.triangles.push_back(
        { triangle[0], triangle[1], static_cast<int>(mesh.points.size()) - 1 });
    }
  }
  // Cells of neighbours are far from each other.
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  mesh.triangleCells.resize(mesh.triangles.size());
  return numbered(buildTriangleMesh(toInput(withoutLoosePoints(mesh))));
}

TriangleMesh moebiusStrips()
{
  TriangleMesh mesh;
  for (const int segments : { 7, 24 })
  {
    const auto first = static_cast<int>(mesh.points.size());
    const double step = 2.0 * std::acos(-1.0) / segments;
    for (int i = 0; i < segments; ++i)
    {
      for (const double side : { -0.3, 0.3 })
      {
        const double rho = 0.1 * segments + side * std::cos(0.5 * i * step);
        mesh.points.push_back(
          { rho * std::cos(i * step), rho * std::sin(i * step), side * std::sin(0.5 * i * step) });
      }
      const bool last = i + 1 == segments;
      const int a = first + 2 * i;
      const int next = first + (last ? 1 : 2 * i + 2);
      const int nextOther = first + (last ? 0 : 2 * i + 3);
      mesh.triangles.push_back({ a, next, a + 1 });
      mesh.triangles.push_back({ a + 1, next, nextOther });
    }
  }
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), std::mt19937(5));
  mesh.triangleCells.resize(mesh.triangles.size());
  return numbered(mesh);
}

Grid gridAround(const TriangleMesh& mesh, int resolution)
{
  return makeGrid(mesh.bounds(), resolution, 0.083);
}

Grid symmetricGrid()
{
  return { { -1.1, -1.1, -1.1 }, { 0.055, 0.055, 0.055 }, { 41, 41, 41 } };
}

} // namespace medial::test

#include "winding_meshes.h"

#include "medial/mesh_io.h"

#include "support/models.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace medial::test
{
namespace
{

TriangleMesh unitBox(const Point3& centre = {})
{
  return translated(box({ 0.5, 0.5, 0.5 }), centre);
}

/// Two parts as one mesh.
Assembly pair(const TriangleMesh& a, const TriangleMesh& b)
{
  return { appended(a, b), { a, b } };
}

/// Two parts as one mesh, without double points.
Assembly weldedPair(const TriangleMesh& a, const TriangleMesh& b)
{
  return { welded(appended(a, b)), { a, b } };
}

/// Two parts as one mesh, the second one inside out.
Assembly pairInsideOut(const TriangleMesh& a, const TriangleMesh& b)
{
  return { appended(a, flipOrientation(b)), { a, b } };
}

TriangleMesh moebiusStrip(int segments)
{
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  const double turn = 2.0 * std::acos(-1.0) / segments;
  for (int i = 0; i < segments; ++i)
  {
    for (const double across : { -0.4, 0.4 })
    {
      const double r = 1.0 + across * std::cos(0.5 * i * turn);
      points.push_back(
        { r * std::cos(i * turn), r * std::sin(i * turn), across * std::sin(0.5 * i * turn) });
    }
  }
  for (int i = 0; i < segments; ++i)
  {
    const bool last = i + 1 == segments;
    const int a = last ? 1 : 2 * i + 2;
    const int b = last ? 0 : 2 * i + 3;
    triangles.push_back({ 2 * i, a, 2 * i + 1 });
    triangles.push_back({ 2 * i + 1, a, b });
  }
  return makeMesh(points, triangles);
}

TriangleMesh everyFourthMissing()
{
  const TriangleMesh ball = icosphere(0.5, 2);
  std::vector<std::size_t> missing;
  for (std::size_t t = 0; t < ball.triangles.size(); t += 4)
  {
    missing.push_back(t);
  }
  return withoutTriangles(ball, missing);
}

} // namespace

TriangleMesh welded(const TriangleMesh& mesh)
{
  return buildTriangleMesh(toInput(mesh));
}

TriangleMesh withoutTriangles(TriangleMesh mesh, const std::vector<std::size_t>& ascending)
{
  for (auto i = ascending.rbegin(); i != ascending.rend(); ++i)
  {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(*i));
    mesh.triangleCells.erase(mesh.triangleCells.begin() + static_cast<std::ptrdiff_t>(*i));
  }
  return mesh;
}

TriangleMesh withFlipped(TriangleMesh mesh, const std::vector<std::size_t>& triangles)
{
  for (const std::size_t t : triangles)
  {
    std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  }
  return mesh;
}

std::vector<Named<Assembly>> assemblies()
{
  const auto ball = [] { return icosphere(0.5, 2); };
  return { { "overlapping",
             [] {
               return pair(unitBox(), unitBox({ 0.6, 0.3, 0.2 }));
             } },
    { "touching",
      [] {
        return pair(unitBox(), unitBox({ 1.0, 0.0, 0.0 }));
      } },
    { "almostTouching",
      [] {
        return pair(unitBox(), unitBox({ 1.0 + 1e-9, 0.0, 0.0 }));
      } },
    { "touchingAlongZ",
      [] {
        return pair(unitBox(), unitBox({ 0.0, 0.0, 1.0 }));
      } },
    { "partsInParts", [=] { return pair(ball(), icosphere(0.2, 1)); } },
    { "onePartInsideOut",
      [] {
        return pairInsideOut(unitBox(), unitBox({ 2.0, 0.0, 0.0 }));
      } },
    { "overlappingInsideOut",
      [] {
        return pairInsideOut(unitBox(), unitBox({ 0.6, 0.3, 0.2 }));
      } },
    { "sharedEdge",
      [] {
        return weldedPair(unitBox(), unitBox({ 1.0, 1.0, 0.0 }));
      } },
    { "sharedFace",
      [] {
        return weldedPair(unitBox(), unitBox({ 1.0, 0.0, 0.0 }));
      } },
    { "flippedTriangles",
      [=] {
        return Assembly{ withFlipped(ball(), { 3, 17, 40 }), { ball() } };
      } },
    { "doubled",
      [=] {
        return Assembly{ welded(appended(ball(), ball())), { ball() } };
      } },
    { "doubleSided",
      [=] {
        return Assembly{ welded(appended(ball(), flipOrientation(ball()))), { ball() } };
      } },
    { "doubledUnwelded",
      [=] {
        return Assembly{ appended(ball(), ball()), { ball() } };
      } },
    { "withSegment",
      []
      {
        return Assembly{ makeMesh(unitBox().points, unitBox().triangles, { { 0, 6 } }),
          { unitBox() } };
      } } };
}

TriangleMesh hemisphere()
{
  const TriangleMesh ball = icosphere(0.5, 2);
  std::vector<std::size_t> lower;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t)
  {
    const auto& [a, b, c] = ball.triangles[t];
    if (ball.points[a][2] + ball.points[b][2] + ball.points[c][2] < 0.0)
    {
      lower.push_back(t);
    }
  }
  return withoutTriangles(ball, lower);
}

std::vector<Named<TriangleMesh>> openMeshes()
{
  std::vector<Named<TriangleMesh>> result{ { "everyFourthTriangleMissing", everyFourthMissing },
    { "oneTriangleMissing", [] { return withoutTriangles(icosphere(0.5, 2), { 5 }); } },
    { "threeHoles",
      [] {
        return withoutTriangles(icosphere(0.5, 2), { 5, 60, 61, 62, 200 });
      } },
    { "hemisphere", hemisphere },
    { "boxWithoutHalfASide", [] { return withoutTriangles(unitBox(), { 0 }); } },
    { "boxWithoutASide",
      [] {
        return withoutTriangles(unitBox(), { 0, 1 });
      } },
    { "moebiusStrip", [] { return moebiusStrip(20); } },
    { "plates", [] { return plates(0.5, 1.0); } },
    { "overlappingHemispheres",
      [] {
        return appended(hemisphere(), translated(hemisphere(), { 0.2, 0.1, 0.05 }));
      } },
    { "oneTriangle",
      [] {
        return makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0.5 } }, { { 0, 1, 2 } });
      } },
    { "soup", [] { return randomSoup(60, 11); } } };
  for (const auto& [name, file] : std::vector<std::pair<const char*, const char*>>{
         { "elephantWithHoles", "soup/elephant_holes_4.5k.off" },
         { "manySmallHoles", "soup/many_small_holes_3.5k.ply" },
         { "doubleSidedChair", "soup/chair_double_sided_12.8k.obj" },
         { "bunnyWithOneHole", "odd/bunny_one_hole.off" } })
  {
    if (const auto path = modelPath(file))
    {
      result.push_back({ name, [path] { return buildTriangleMesh(readMesh(*path)); } });
    }
  }
  return result;
}

TriangleMesh defective(std::mt19937& random)
{
  const std::vector<TriangleMesh> shapes{ icosphere(0.5, 1), torus(0.5, 0.2, 8, 5),
    shell(0.3, 0.5, 1), appended(unitBox(), unitBox({ 0.6, 0.3, 0.2 })), unitBox() };
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  TriangleMesh mesh = shapes[below(shapes.size())];
  const auto triangle = [&] { return below(mesh.triangles.size()); };
  for (std::size_t i = below(4); i > 0; --i)
  {
    mesh = withoutTriangles(mesh, { triangle() });
  }
  for (std::size_t i = below(4); i > 0; --i)
  {
    mesh = withFlipped(mesh, { triangle() });
  }
  for (std::size_t i = below(4); i > 0; --i)
  {
    const auto copy = mesh.triangles[triangle()];
    mesh.triangles.push_back({ copy[1], copy[0], copy[2] });
    mesh.triangleCells.push_back(static_cast<std::int64_t>(mesh.triangles.size()));
  }
  for (std::size_t i = below(3); i > 0; --i)
  {
    mesh.points[below(mesh.points.size())] = mesh.points[below(mesh.points.size())];
  }
  return welded(mesh);
}

} // namespace medial::test

#include "support/transforms.h"

#include "support/point_math.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>

namespace medial::test
{

namespace
{

template <class Function>
TriangleMesh transformed(TriangleMesh mesh, Function function)
{
  for (Point3& point : mesh.points)
  {
    point = function(point);
  }
  return mesh;
}

} // namespace

TriangleMesh makeMesh(const std::vector<Point3>& points,
  const std::vector<std::array<int, 3>>& triangles, const std::vector<std::array<int, 2>>& segments,
  const std::vector<int>& vertices)
{
  MeshInput input;
  input.points = points;
  std::int64_t cell = 0;
  for (const auto& t : triangles)
  {
    input.polygons.append({ t[0], t[1], t[2] }, cell++);
  }
  for (const auto& s : segments)
  {
    input.lines.append({ s[0], s[1] }, cell++);
  }
  for (const int vertex : vertices)
  {
    input.verts.append({ vertex }, cell++);
  }
  return buildTriangleMesh(input);
}

MeshInput toInput(const TriangleMesh& mesh)
{
  MeshInput input;
  input.points = mesh.points;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& t = mesh.triangles[i];
    input.polygons.append({ t[0], t[1], t[2] }, mesh.triangleCells[i]);
  }
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
  {
    input.lines.append({ mesh.segments[i][0], mesh.segments[i][1] }, mesh.segmentCells[i]);
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
  {
    input.verts.append({ mesh.vertices[i] }, mesh.vertexCells[i]);
  }
  return input;
}

MeshInput unwelded(const TriangleMesh& mesh)
{
  MeshInput input = toInput(mesh);
  input.points.clear();
  for (CellList* cells : { &input.polygons, &input.lines, &input.verts })
  {
    for (std::int64_t& point : cells->connectivity)
    {
      input.points.push_back(mesh.points[point]);
      point = static_cast<std::int64_t>(input.points.size()) - 1;
    }
  }
  return input;
}

TriangleMesh translated(TriangleMesh mesh, const Point3& offset)
{
  return transformed(std::move(mesh),
    [&](const Point3& p) -> Point3 {
      return { p[0] + offset[0], p[1] + offset[1], p[2] + offset[2] };
    });
}

TriangleMesh scaled(TriangleMesh mesh, double factor)
{
  return transformed(std::move(mesh),
    [=](const Point3& p) -> Point3 {
      return { factor * p[0], factor * p[1], factor * p[2] };
    });
}

TriangleMesh turned(TriangleMesh mesh, int axis, double angle)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  return transformed(std::move(mesh),
    [=](Point3 p)
    {
      const double x = p[u];
      p[u] = std::cos(angle) * x - std::sin(angle) * p[v];
      p[v] = std::sin(angle) * x + std::cos(angle) * p[v];
      return p;
    });
}

TriangleMesh rotated90(TriangleMesh mesh, int axis)
{
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  return transformed(std::move(mesh),
    [=](Point3 p)
    {
      std::swap(p[u], p[v]);
      p[u] = -p[u];
      return p;
    });
}

TriangleMesh mirrored(TriangleMesh mesh, int axis)
{
  return flipOrientation(transformed(std::move(mesh),
    [=](Point3 p)
    {
      p[axis] = -p[axis];
      return p;
    }));
}

TriangleMesh flipOrientation(TriangleMesh mesh)
{
  for (auto& t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

TriangleMesh subdivided(TriangleMesh mesh, int times)
{
  for (; times > 0; --times)
  {
    std::vector<Point3> points = mesh.points;
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b)
    {
      const auto [place, isNew] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (isNew)
      {
        const Point3& p = mesh.points[a];
        const Point3& q = mesh.points[b];
        points.push_back({ 0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]) });
      }
      return place->second;
    };
    std::vector<std::array<int, 3>> triangles;
    for (const auto& [a, b, c] : mesh.triangles)
    {
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      triangles.insert(triangles.end(),
        { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
    }
    mesh = makeMesh(points, triangles);
  }
  return mesh;
}

TriangleMesh withFlatTriangles(const TriangleMesh& mesh, int places, double height,
  unsigned int seed)
{
  std::mt19937 generator(seed);
  const auto random = [&](std::size_t count) { return generator() % count; };
  const auto share = [&]() { return static_cast<double>(generator()) / 4294967296.0; };
  std::vector<Point3> points = mesh.points;
  std::vector<std::array<int, 3>> triangles = mesh.triangles;
  for (int place = 0; place < places; ++place)
  {
    const std::size_t divided = random(triangles.size());
    const std::size_t side = random(3);
    const int a = triangles[divided][side];
    const int b = triangles[divided][(side + 1) % 3];
    const int c = triangles[divided][(side + 2) % 3];
    const double along = 0.1 + 0.8 * share();
    const double angle = 6.28 * share();
    const double length = distance(points[a], points[b]);
    Point3 between{};
    for (int axis = 0; axis < 3; ++axis)
    {
      between[axis] = (1.0 - along) * points[a][axis] + along * points[b][axis];
    }
    between[0] += height * length * std::cos(angle);
    between[1] += height * length * std::sin(angle);
    const auto middle = static_cast<int>(points.size());
    points.push_back(between);
    triangles[divided] = { a, middle, c };
    triangles.push_back({ middle, b, c });
    triangles.push_back({ a, b, middle });
  }
  return makeMesh(points, triangles);
}

TriangleMesh appended(const TriangleMesh& a, const TriangleMesh& b)
{
  MeshInput input = toInput(a);
  const MeshInput second = toInput(b);
  std::int64_t firstId = 0;
  for (const CellList* cells : { &input.polygons, &input.lines, &input.verts })
  {
    for (const std::int64_t id : cells->ids)
    {
      firstId = std::max(firstId, id + 1);
    }
  }
  const auto join = [&](CellList& to, const CellList& from)
  {
    for (std::int64_t cell = 0; cell < from.size(); ++cell)
    {
      std::vector<std::int64_t> points(from.connectivity.begin() + from.offsets[cell],
        from.connectivity.begin() + from.offsets[cell + 1]);
      for (std::int64_t& point : points)
      {
        point += static_cast<std::int64_t>(a.points.size());
      }
      to.append(points, from.ids[cell] + firstId);
    }
  };
  join(input.polygons, second.polygons);
  join(input.lines, second.lines);
  join(input.verts, second.verts);
  input.points.insert(input.points.end(), second.points.begin(), second.points.end());
  return buildTriangleMesh(input);
}

} // namespace medial::test

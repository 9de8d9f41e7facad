#include "support/shapes.h"

#include "support/point_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace medial::test
{

namespace
{

using Point2 = std::array<double, 2>;

/// Collects polygons by their coordinates; welding joins them.
class Soup
{
public:
  void add(const std::vector<Point3>& polygon)
  {
    std::vector<std::int64_t> ids;
    for (const Point3& corner : polygon)
    {
      ids.push_back(static_cast<std::int64_t>(input_.points.size()));
      input_.points.push_back(corner);
    }
    input_.polygons.append(ids, input_.polygons.size());
  }

  TriangleMesh build() const
  {
    const TriangleMesh welded = buildTriangleMesh(input_);
    return makeMesh(welded.points, welded.triangles);
  }

private:
  MeshInput input_;
};

Point3 unitVector(const Point3& p)
{
  const double length = std::hypot(p[0], p[1], p[2]);
  return { p[0] / length, p[1] / length, p[2] / length };
}

Point3 middleOnSphere(const Point3& a, const Point3& b)
{
  return unitVector({ a[0] + b[0], a[1] + b[1], a[2] + b[2] });
}

void addSphereTriangle(Soup& soup, const Point3& a, const Point3& b, const Point3& c,
  int subdivisions)
{
  if (subdivisions == 0)
  {
    soup.add({ a, b, c });
    return;
  }
  const Point3 ab = middleOnSphere(a, b);
  const Point3 bc = middleOnSphere(b, c);
  const Point3 ca = middleOnSphere(c, a);
  addSphereTriangle(soup, a, ab, ca, subdivisions - 1);
  addSphereTriangle(soup, b, bc, ab, subdivisions - 1);
  addSphereTriangle(soup, c, ca, bc, subdivisions - 1);
  addSphereTriangle(soup, ab, bc, ca, subdivisions - 1);
}

/// Prism over an anticlockwise polygon, |z| <= halfHeight.
TriangleMesh prism(const std::vector<Point2>& polygon, double halfHeight)
{
  Soup soup;
  std::vector<Point3> bottom;
  std::vector<Point3> top;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const auto [x, y] = polygon[i];
    const auto [nextX, nextY] = polygon[(i + 1) % polygon.size()];
    soup.add({ { x, y, -halfHeight }, { nextX, nextY, -halfHeight }, { nextX, nextY, halfHeight },
      { x, y, halfHeight } });
    bottom.insert(bottom.begin(), { x, y, -halfHeight });
    top.push_back({ x, y, halfHeight });
  }
  soup.add(bottom);
  soup.add(top);
  return soup.build();
}

/// Turns a profile of (distance from the axis, z) about the z axis; it rises, both ends on the
/// axis.
TriangleMesh revolved(const std::vector<Point2>& profile, int segments)
{
  const auto at = [&](std::size_t row, int segment) -> Point3
  {
    const double angle = 2.0 * kPi * (segment % segments) / segments;
    const auto [rho, z] = profile[row];
    return { rho * std::cos(angle), rho * std::sin(angle), z };
  };
  Soup soup;
  for (std::size_t row = 0; row + 1 < profile.size(); ++row)
  {
    for (int i = 0; i < segments; ++i)
    {
      if (profile[row][0] == 0.0)
      {
        soup.add({ at(row, i), at(row + 1, i + 1), at(row + 1, i) });
      }
      else if (profile[row + 1][0] == 0.0)
      {
        soup.add({ at(row, i), at(row, i + 1), at(row + 1, i) });
      }
      else
      {
        soup.add({ at(row, i), at(row, i + 1), at(row + 1, i + 1), at(row + 1, i) });
      }
    }
  }
  return soup.build();
}

} // namespace

TriangleMesh box(const Point3& halfSides)
{
  const auto [a, b, c] = halfSides;
  return prism({ { -a, -b }, { a, -b }, { a, b }, { -a, b } }, c);
}

TriangleMesh lPrism(double halfSide, double halfHeight)
{
  const double a = halfSide;
  return prism({ { -a, -a }, { a, -a }, { a, 0.0 }, { 0.0, 0.0 }, { 0.0, a }, { -a, a } },
    halfHeight);
}

TriangleMesh icosphere(double radius, int subdivisions)
{
  const double phi = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Point3> points;
  for (const double s : { -1.0, 1.0 })
  {
    for (const double t : { -phi, phi })
    {
      points.insert(points.end(), { { 0.0, s, t }, { s, t, 0.0 }, { t, 0.0, s } });
    }
  }
  const auto isSide = [](const Point3& a, const Point3& b)
  { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 2.1; };
  Soup soup;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = i + 1; j < points.size(); ++j)
    {
      for (std::size_t k = j + 1; k < points.size(); ++k)
      {
        const Point3& a = points[i];
        const Point3& b = points[j];
        const Point3& c = points[k];
        if (isSide(a, b) && isSide(b, c) && isSide(c, a))
        {
          const double volume = a[0] * (b[1] * c[2] - b[2] * c[1]) +
            a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
          addSphereTriangle(soup, unitVector(a), unitVector(volume > 0.0 ? b : c),
            unitVector(volume > 0.0 ? c : b), subdivisions);
        }
      }
    }
  }
  return scaled(soup.build(), radius);
}

TriangleMesh ellipsoid(double a, double b, double c, int subdivisions)
{
  TriangleMesh mesh = icosphere(1.0, subdivisions);
  for (Point3& p : mesh.points)
  {
    p = { a * p[0], b * p[1], c * p[2] };
  }
  return mesh;
}

TriangleMesh uvCapsule(double radius, double halfLength, int segments)
{
  const int quarter = segments / 4;
  std::vector<Point2> profile;
  for (const double end : { -1.0, 1.0 })
  {
    for (int i = 0; i <= quarter; ++i)
    {
      const int step = end < 0.0 ? quarter - i : i;
      const double angle = 0.5 * kPi * step / quarter;
      const double rho = step == quarter ? 0.0 : radius * std::cos(angle);
      profile.push_back({ rho, end * (halfLength + radius * std::sin(angle)) });
    }
  }
  profile.erase(std::unique(profile.begin(), profile.end()), profile.end());
  return revolved(profile, segments);
}

TriangleMesh torus(double R, double rho, int nu, int nv)
{
  const auto at = [&](int i, int j) -> Point3
  {
    const double u = 2.0 * kPi * (i % nu) / nu;
    const double v = 2.0 * kPi * (j % nv) / nv;
    const double fromAxis = R + rho * std::cos(v);
    return { fromAxis * std::cos(u), fromAxis * std::sin(u), rho * std::sin(v) };
  };
  Soup soup;
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < nv; ++j)
    {
      soup.add({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return soup.build();
}

TriangleMesh cylinder(double radius, double height, int n)
{
  const double z = 0.5 * height;
  return revolved({ { 0.0, -z }, { radius, -z }, { radius, z }, { 0.0, z } }, n);
}

TriangleMesh shell(double inner, double outer, int subdivisions)
{
  return appended(icosphere(outer, subdivisions), flipOrientation(icosphere(inner, subdivisions)));
}

TriangleMesh plates(double gap, double halfSide)
{
  const double a = halfSide;
  const double z = 0.5 * gap;
  return makeMesh({ { -a, -a, -z }, { a, -a, -z }, { a, a, -z }, { -a, a, -z }, { -a, -a, z },
                    { a, -a, z }, { a, a, z }, { -a, a, z } },
    { { 0, 2, 1 }, { 0, 3, 2 }, { 4, 5, 6 }, { 4, 6, 7 } });
}

TriangleMesh wedge(double dihedral, double length, double width)
{
  const double half = 0.5 * dihedral * kPi / 180.0;
  const double x = width * std::cos(half);
  const double y = width * std::sin(half);
  if (dihedral < 180.0)
  {
    return prism({ { 0.0, 0.0 }, { x, -y }, { x, y } }, 0.5 * length);
  }
  return prism({ { 0.0, 0.0 }, { x, -y }, { x, -width }, { width, -width }, { width, width },
                 { x, width }, { x, y } },
    0.5 * length);
}

TriangleMesh regularTetrahedron(double edge)
{
  const double a = edge / std::sqrt(8.0);
  return makeMesh({ { a, a, a }, { a, -a, -a }, { -a, a, -a }, { -a, -a, a } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } });
}

TriangleMesh blocks(const std::vector<std::string>& rows, double halfHeight)
{
  const auto filled = [&](int x, int y)
  {
    const auto row = static_cast<std::size_t>(-y);
    return y <= 0 && row < rows.size() && x >= 0 &&
      static_cast<std::size_t>(x) < rows[row].size() && rows[row][x] == '#';
  };
  Soup soup;
  const double z = halfHeight;
  for (int row = 0; row < static_cast<int>(rows.size()); ++row)
  {
    for (int x = 0; x < static_cast<int>(rows[row].size()); ++x)
    {
      const int y = -row;
      if (!filled(x, y))
      {
        continue;
      }
      const std::array<Point2, 4> corners{ { { x - 0.5, y - 0.5 }, { x + 0.5, y - 0.5 },
        { x + 0.5, y + 0.5 }, { x - 0.5, y + 0.5 } } };
      const std::array<std::array<int, 2>, 4> beside{ { { x, y - 1 }, { x + 1, y }, { x, y + 1 },
        { x - 1, y } } };
      std::vector<Point3> top;
      for (int side = 0; side < 4; ++side)
      {
        const auto [ax, ay] = corners[side];
        const auto [bx, by] = corners[(side + 1) % 4];
        top.push_back({ ax, ay, z });
        if (!filled(beside[side][0], beside[side][1]))
        {
          soup.add({ { ax, ay, -z }, { bx, by, -z }, { bx, by, z }, { ax, ay, z } });
        }
      }
      soup.add(top);
      soup.add({ { x - 0.5, y - 0.5, -z }, { x - 0.5, y + 0.5, -z }, { x + 0.5, y + 0.5, -z },
        { x + 0.5, y - 0.5, -z } });
    }
  }
  return soup.build();
}

TriangleMesh hair(double halfLength, int sides)
{
  constexpr double kRadius = 1e-17;
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < sides; ++i)
  {
    // An angle without symmetry, lest coordinates are equal.
    const double y = kRadius * std::cos(1.0 + 1.1 * i);
    const double z = kRadius * std::sin(1.0 + 1.1 * i);
    const int next = (i + 1) % sides;
    points.insert(points.end(), { { -halfLength, y, z }, { halfLength, y, z } });
    triangles.push_back({ 2 * i, 2 * next, 2 * i + 1 });
    triangles.push_back({ 2 * next, 2 * next + 1, 2 * i + 1 });
  }
  return makeMesh(points, triangles);
}

TriangleMesh randomSoup(int n, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto coordinate = [&] { return static_cast<double>(random()) / 2147483648.0 - 1.0; };
  Soup soup;
  for (int i = 0; i < n; ++i)
  {
    std::vector<Point3> corners(3);
    for (Point3& corner : corners)
    {
      std::generate(corner.begin(), corner.end(), coordinate);
    }
    soup.add(corners);
  }
  return soup.build();
}

} // namespace medial::test

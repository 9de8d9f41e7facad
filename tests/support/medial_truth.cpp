#include "support/medial_truth.h"

#include "support/point_math.h"
#include "support/shapes.h"

#include <array>
#include <cmath>

namespace medial::test
{

namespace
{

/// Collects polygons and polylines by their coordinates.
class Pieces
{
public:
  /// A sheet; its border counts as curves.
  void sheet(const std::vector<Point3>& corners)
  {
    sheets_.polygons.append(this->insert(sheets_, corners), sheets_.polygons.size());
    std::vector<Point3> border = corners;
    border.push_back(corners.front());
    this->border(border);
  }

  /// A part of a curved sheet.
  void facet(const std::vector<Point3>& corners)
  {
    sheets_.polygons.append(this->insert(sheets_, corners), sheets_.polygons.size());
  }

  void border(const std::vector<Point3>& line)
  {
    curves_.lines.append(this->insert(curves_, line), 0);
  }

  /// A part of the axis that is a curve.
  void curve(const std::vector<Point3>& line)
  {
    sheets_.lines.append(this->insert(sheets_, line), 0);
    this->border(line);
  }

  TriangleMesh axis() const { return buildTriangleMesh(sheets_); }
  TriangleMesh curves() const { return buildTriangleMesh(curves_); }

private:
  std::vector<std::int64_t> insert(MeshInput& input, const std::vector<Point3>& points) const
  {
    std::vector<std::int64_t> ids;
    for (const Point3& point : points)
    {
      ids.push_back(static_cast<std::int64_t>(input.points.size()));
      input.points.push_back(point);
    }
    return ids;
  }

  MeshInput sheets_;
  MeshInput curves_;
};

MedialTruth truth(TriangleMesh shape, const Pieces& pieces, double angle, double spacing)
{
  return { std::move(shape), pieces.axis(), pieces.curves(), angle, spacing };
}

void addBoxEdgeSheets(Pieces& pieces, const Point3& halfSides)
{
  const auto [a, b, c] = halfSides;
  for (const double sy : { -1.0, 1.0 })
  {
    for (const double sz : { -1.0, 1.0 })
    {
      const double y = sy * b;
      const double z = sz * c;
      const double inner = sy * (b - c);
      pieces.sheet({ { -a, y, z }, { a, y, z }, { a - c, inner, 0.0 }, { c - a, inner, 0.0 } });
      // The same signs serve for the edges along y.
      const double x = sy * a;
      const double innerX = sy * (a - c);
      pieces.sheet({ { x, -b, z }, { x, b, z }, { innerX, b - c, 0.0 }, { innerX, c - b, 0.0 } });
      const double otherY = sz * b;
      pieces.sheet({ { x, otherY, -c }, { x, otherY, c }, { innerX, sz * (b - c), 0.0 } });
    }
  }
}

/// Rows of a rotation by 37 degrees about (1, 2, 3).
using Rows = std::array<Point3, 3>;

const Rows& rotation()
{
  static const Rows rows = []
  {
    const double angle = 37.0 * kPi / 180.0;
    const double norm = std::sqrt(14.0);
    const Point3 u{ 1.0 / norm, 2.0 / norm, 3.0 / norm };
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Point3 w[3] = { { 0.0, -u[2], u[1] }, { u[2], 0.0, -u[0] }, { -u[1], u[0], 0.0 } };
    Rows result{};
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        result[i][j] = (1.0 - c) * u[i] * u[j] + s * w[i][j] + (i == j ? c : 0.0);
      }
    }
    return result;
  }();
  return rows;
}

} // namespace

Point3 tilted(const Point3& point)
{
  Point3 result{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      result[i] += rotation()[i][j] * point[j];
    }
  }
  return result;
}

Point3 untilted(const Point3& point)
{
  Point3 result{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      result[i] += rotation()[j][i] * point[j];
    }
  }
  return result;
}

TriangleMesh tilted(TriangleMesh mesh)
{
  for (Point3& point : mesh.points)
  {
    point = tilted(point);
  }
  return mesh;
}

MedialTruth tilted(const MedialTruth& truth)
{
  return { tilted(truth.shape), tilted(truth.axis), tilted(truth.curves), truth.angle,
    truth.spacing };
}

MedialTruth boxTruth(const Point3& halfSides, double angle)
{
  const auto [a, b, c] = halfSides;
  Pieces pieces;
  pieces.sheet(
    { { c - a, c - b, 0.0 }, { a - c, c - b, 0.0 }, { a - c, b - c, 0.0 }, { c - a, b - c, 0.0 } });
  if (angle < 90.0)
  {
    addBoxEdgeSheets(pieces, halfSides);
  }
  return truth(box(halfSides), pieces, angle, 0.043);
}

MedialTruth ballTruth()
{
  Pieces pieces;
  pieces.curve({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } });
  return truth(icosphere(1.0, 5), pieces, 60.0, 0.053);
}

MedialTruth capsuleTruth()
{
  Pieces pieces;
  pieces.curve({ { 0.0, 0.0, -0.8 }, { 0.0, 0.0, 0.8 } });
  return truth(uvCapsule(0.6, 0.8, 96), pieces, 60.0, 0.047);
}

MedialTruth torusTruth()
{
  constexpr int kSegments = 160;
  std::vector<Point3> circle;
  for (int i = 0; i <= kSegments; ++i)
  {
    const double angle = 2.0 * kPi * (i % kSegments) / kSegments;
    circle.push_back({ std::cos(angle), std::sin(angle), 0.0 });
  }
  Pieces pieces;
  pieces.curve(circle);
  return truth(torus(1.0, 0.4, kSegments, 64), pieces, 60.0, 0.041);
}

MedialTruth cylinderTruth()
{
  constexpr int kSides = 160;
  const double radius = 0.5;
  const double top = 1.0;
  Pieces pieces;
  pieces.curve({ { 0.0, 0.0, radius - top }, { 0.0, 0.0, top - radius } });
  for (int i = 0; i < kSides; ++i)
  {
    const double u = 2.0 * kPi * i / kSides;
    const double v = 2.0 * kPi * (i + 1) / kSides;
    for (const double z : { -top, top })
    {
      const double apex = z < 0.0 ? z + radius : z - radius;
      const Point3 p{ radius * std::cos(u), radius * std::sin(u), z };
      const Point3 q{ radius * std::cos(v), radius * std::sin(v), z };
      pieces.facet({ { 0.0, 0.0, apex }, p, q });
      pieces.border({ p, q });
    }
  }
  return truth(cylinder(radius, 2.0 * top, kSides), pieces, 60.0, 0.037);
}

MedialTruth shellTruth()
{
  MedialTruth result = ballTruth();
  result.shape = shell(0.5, 1.0, 4);
  result.axis = icosphere(0.75, 5);
  result.curves = {};
  return result;
}

MedialTruth tetrahedronTruth()
{
  const TriangleMesh shape = regularTetrahedron(2.0);
  Pieces pieces;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t j = i + 1; j < 4; ++j)
    {
      pieces.sheet({ { 0.0, 0.0, 0.0 }, shape.points[i], shape.points[j] });
    }
  }
  return truth(shape, pieces, 60.0, 0.031);
}

std::vector<Named<MedialTruth>> medialTruths()
{
  const auto narrowBox = [] { return boxTruth({ 1.1, 0.8, 0.5 }, 60.0); };
  const auto wideBox = [] { return boxTruth({ 1.1, 0.8, 0.5 }, 120.0); };
  std::vector<Named<MedialTruth>> truths;
  const auto add = [&](const std::string& name, const std::function<MedialTruth()>& make) {
    truths.push_back({ name, make });
  };
  const auto addBoth = [&](const std::string& name, const std::function<MedialTruth()>& make)
  {
    add(name, make);
    add(name + "Tilted", [make] { return tilted(make()); });
  };
  addBoth("box", narrowBox);
  addBoth("boxAtWideAngle", wideBox);
  add("ball", ballTruth);
  addBoth("capsule", capsuleTruth);
  add("torus", torusTruth);
  addBoth("cylinder", cylinderTruth);
  add("shell", shellTruth);
  addBoth("tetrahedron", tetrahedronTruth);
  return truths;
}

} // namespace medial::test

#include "support/analytic_solids.h"

#include "support/analytic_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <array>
#include <utility>

namespace medial::test
{
namespace
{

/// A rotation by angles that are not round.
const std::array<Point3, 3> kTurn = []
{
  const double a = 0.41;
  const double b = 0.73;
  return std::array<Point3, 3>{ { { std::cos(a), -std::sin(a), 0.0 },
    { std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), -std::sin(b) },
    { std::sin(a) * std::sin(b), std::cos(a) * std::sin(b), std::cos(b) } } };
}();

Point3 turned(const Point3& p)
{
  return { dot(kTurn[0], p), dot(kTurn[1], p), dot(kTurn[2], p) };
}

Point3 turnedBack(const Point3& p)
{
  Point3 result{ 0.0, 0.0, 0.0 };
  for (int row = 0; row < 3; ++row)
  {
    for (int i = 0; i < 3; ++i)
    {
      result[i] += kTurn[row][i] * p[row];
    }
  }
  return result;
}

/// The same shape, turned.
AnalyticAxis turned(AnalyticAxis axis)
{
  const auto shape = [straight = std::move(axis.shape)](double h)
  {
    MeshInput input = toInput(straight(h));
    std::transform(input.points.begin(), input.points.end(), input.points.begin(),
      [](const Point3& p) { return turned(p); });
    return buildTriangleMesh(input);
  };
  axis.bounds = shape(axis.spacing).bounds();
  for (int i = 0; i < 3; ++i)
  {
    axis.bounds.min[i] -= 2.0 * axis.spacing;
    axis.bounds.max[i] += 2.0 * axis.spacing;
  }
  axis.shape = shape;
  axis.truth = [truth = std::move(axis.truth)](const Point3& p) { return truth(turnedBack(p)); };
  axis.regular = [regular = std::move(axis.regular)](const Point3& p, double h)
  { return regular(turnedBack(p), h); };
  return axis;
}

/// dot(normal, x) <= offset.
struct Plane
{
  Point3 normal;
  double offset;
};

/// Axis of a convex polyhedron at p: between its two nearest planes.
struct NearestPlanes
{
  std::array<double, 3> distance; ///< ascending
  Point3 first, second;           ///< normals

  NearestPlanes(const std::vector<Plane>& planes, const Point3& p)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
      order.emplace_back(planes[i].offset - dot(planes[i].normal, p), i);
    }
    std::array<std::pair<double, std::size_t>, 3> nearest;
    std::partial_sort_copy(order.begin(), order.end(), nearest.begin(), nearest.end());
    distance = { nearest[0].first, nearest[1].first, nearest[2].first };
    first = planes[nearest[0].second].normal;
    second = planes[nearest[1].second].normal;
  }

  AxisTruth truth() const
  {
    const double cosine = dot(first, second);
    return { (distance[1] - distance[0]) / length(minus(first, second)),
      0.5 * (distance[0] + distance[1]), degrees(std::acos(std::clamp(cosine, -1.0, 1.0))) };
  }
};

AnalyticAxis polyhedron(const std::vector<Plane>& planes)
{
  AnalyticAxis axis;
  axis.truth = [planes](const Point3& p) { return NearestPlanes(planes, p).truth(); };
  axis.regular = [planes](const Point3& p, double h)
  {
    const NearestPlanes nearest(planes, p);
    return nearest.distance[2] - nearest.distance[1] > 2.0 * h && nearest.distance[0] > h;
  };
  return axis;
}

AnalyticAxis boxAxis()
{
  constexpr double a = 0.9;
  constexpr double b = 0.6;
  constexpr double c = 0.4;
  const Point3 half{ a, b, c };
  std::vector<Plane> planes;
  for (int i = 0; i < 3; ++i)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      Plane plane{ { 0.0, 0.0, 0.0 }, half[i] };
      plane.normal[i] = sign;
      planes.push_back(plane);
    }
  }
  AnalyticAxis axis = polyhedron(planes);
  axis.shape = [half](double) { return box(half); };
  axis.spacing = 0.06;
  axis.angle = 60.0;
  axis.area = 4.0 * (a - c) * (b - c) + 4.0 * std::sqrt(2.0) * (2.0 * c * (a + b) - c * c);
  return turned(axis);
}

AnalyticAxis tetrahedron()
{
  constexpr double kEdge = 2.0;
  const TriangleMesh mesh = regularTetrahedron(kEdge);
  const double inradius = kEdge * std::sqrt(6.0) / 12.0;
  std::vector<Plane> planes;
  for (const Point3& corner : mesh.points)
  {
    // Each face is opposite a corner.
    const double size = length(corner);
    planes.push_back({ { -corner[0] / size, -corner[1] / size, -corner[2] / size }, inradius });
  }
  AnalyticAxis axis = polyhedron(planes);
  axis.shape = [](double) { return regularTetrahedron(kEdge); };
  axis.spacing = 0.06;
  axis.angle = 60.0;
  axis.area = 6.0 * kEdge * kEdge / (4.0 * std::sqrt(2.0));
  return turned(axis);
}

/// An axis that is a point or curve: facets thicken it by up to h/(2 sin(theta/2)) + h/2.
void makeCurve(AnalyticAxis& axis)
{
  axis.angle = 60.0;
  axis.isCurve = true;
}

AnalyticAxis ball()
{
  AnalyticAxis axis;
  axis.shape = [](double h) { return icosphere(1.0, subdivisions(h)); };
  axis.bounds = around({ 1.1, 1.1, 1.1 });
  axis.spacing = 0.08;
  axis.truth = [](const Point3& p) { return AxisTruth{ length(p), 1.0, 180.0 }; };
  makeCurve(axis);
  return axis;
}

AnalyticAxis capsule()
{
  constexpr double kRadius = 0.5;
  constexpr double kHalf = 0.6;
  AnalyticAxis axis;
  axis.shape = [](double h) { return uvCapsule(kRadius, kHalf, segments(h)); };
  axis.bounds = around({ 0.6, 0.6, 1.2 });
  axis.spacing = 0.06;
  axis.truth = [](const Point3& p)
  {
    const double beyond = std::max(0.0, std::abs(p[2]) - kHalf);
    return AxisTruth{ std::hypot(p[0], p[1], beyond), kRadius, 180.0 };
  };
  makeCurve(axis);
  return turned(axis);
}

AnalyticAxis torusAxis()
{
  constexpr double kCircle = 0.8;
  constexpr double kTube = 0.35;
  AnalyticAxis axis;
  axis.shape = [](double h) { return torus(kCircle, kTube, 2 * segments(h), segments(h)); };
  axis.spacing = 0.06;
  axis.truth = [](const Point3& p) {
    return AxisTruth{ std::hypot(std::hypot(p[0], p[1]) - kCircle, p[2]), kTube, 180.0 };
  };
  makeCurve(axis);
  return turned(axis);
}

/// Higher than wide: a segment and two cones.
AnalyticAxis tallCylinder()
{
  constexpr double kRadius = 0.4;
  constexpr double kHalf = 0.9;
  AnalyticAxis axis;
  axis.shape = [](double h) { return cylinder(kRadius, 2.0 * kHalf, 4 * segments(h)); };
  axis.bounds = around({ 0.5, 0.5, 1.0 });
  axis.spacing = 0.05;
  axis.angle = 70.0;
  axis.truth = [](const Point3& p)
  {
    const double toWall = kRadius - std::hypot(p[0], p[1]);
    const double toCap = kHalf - std::abs(p[2]);
    return AxisTruth{ std::abs(toWall - toCap) / std::sqrt(2.0), 0.5 * (toWall + toCap), 90.0 };
  };
  // The cones only: the segment is as the capsule's.
  axis.regular = [](const Point3& p, double h)
  {
    const double rho = std::hypot(p[0], p[1]);
    return rho > 2.0 * h && rho < kRadius - 2.0 * h;
  };
  axis.area = 2.0 * std::sqrt(2.0) * kPi * kRadius * kRadius;
  return axis;
}

/// Lower than wide: a flat disc and two cones.
AnalyticAxis disc()
{
  constexpr double kRadius = 1.0;
  constexpr double kHalf = 0.3;
  AnalyticAxis axis;
  axis.shape = [](double h) { return cylinder(kRadius, 2.0 * kHalf, 4 * segments(h)); };
  axis.bounds = around({ 1.2, 1.2, 0.5 });
  axis.spacing = 0.07;
  axis.angle = 70.0;
  axis.truth = [](const Point3& p)
  {
    const double rho = std::hypot(p[0], p[1]);
    const double toCap = kHalf - std::abs(p[2]);
    const double toWall = kRadius - rho;
    if (rho < kRadius - kHalf)
    {
      return AxisTruth{ std::abs(p[2]), kHalf, 180.0 };
    }
    return AxisTruth{ std::abs(toWall - toCap) / std::sqrt(2.0), 0.5 * (toWall + toCap), 90.0 };
  };
  axis.regular = [](const Point3& p, double h)
  {
    const double rho = std::hypot(p[0], p[1]);
    return std::abs(rho - (kRadius - kHalf)) > 2.0 * h && rho < kRadius - 2.0 * h;
  };
  const double inner = kRadius - kHalf;
  axis.area = kPi * inner * inner + 2.0 * kPi * (inner + kRadius) * kHalf * std::sqrt(2.0);
  return axis;
}

AnalyticAxis shellAxis()
{
  constexpr double kInner = 0.5;
  constexpr double kOuter = 1.0;
  AnalyticAxis axis;
  axis.shape = [](double h) { return shell(kInner, kOuter, subdivisions(h)); };
  axis.bounds = around({ 1.1, 1.1, 1.1 });
  axis.spacing = 0.08;
  axis.angle = 90.0;
  constexpr double kMiddle = 0.5 * (kInner + kOuter);
  axis.truth = [](const Point3& p) {
    return AxisTruth{ std::abs(length(p) - kMiddle), 0.5 * (kOuter - kInner), 180.0 };
  };
  axis.area = 4.0 * kPi * kMiddle * kMiddle;
  return axis;
}

AnalyticAxis holeOfShell()
{
  AnalyticAxis axis = ball();
  constexpr double kInner = 0.6;
  axis.shape = [](double h) { return shell(kInner, 1.0, subdivisions(h)); };
  axis.truth = [](const Point3& p) { return AxisTruth{ length(p), kInner, 180.0 }; };
  axis.side = Side::Exterior;
  return axis;
}

} // namespace

std::vector<Named<AnalyticAxis>> analyticSolids()
{
  return { { "box", boxAxis }, { "tetrahedron", tetrahedron }, { "ball", ball },
    { "capsule", capsule }, { "torus", torusAxis }, { "cylinder", tallCylinder }, { "disc", disc },
    { "shell", shellAxis }, { "holeOfShell", holeOfShell } };
}

} // namespace medial::test

#include "support/analytic_axes.h"

#include "support/analytic_math.h"
#include "support/analytic_solids.h"
#include "support/axes.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <algorithm>
#include <cmath>

namespace medial::test
{
namespace
{

/// Degrees between the directions from x to two points.
double angleAt(const Point3& x, const Point3& a, const Point3& b)
{
  const Point3 u = minus(a, x);
  const Point3 v = minus(b, x);
  return degrees(std::acos(std::clamp(dot(u, v) / (length(u) * length(v)), -1.0, 1.0)));
}

AnalyticAxis triaxialEllipsoid()
{
  constexpr double a = 1.0;
  constexpr double b = 0.8;
  constexpr double c = 0.45;
  AnalyticAxis axis;
  axis.shape = [](double h) { return ellipsoid(a, b, c, subdivisions(h) + 1); };
  axis.bounds = around({ 1.1, 0.9, 0.55 });
  axis.spacing = 0.06;
  axis.angle = 80.0;
  axis.truth = [](const Point3& p)
  {
    const double u = p[0] * p[0] / (a * a - c * c);
    const double v = p[1] * p[1] / (b * b - c * c);
    const double radius = c * std::sqrt(std::max(0.0, 1.0 - u - v));
    const double px = p[0] * a / (a * a - c * c);
    const double py = p[1] * b / (b * b - c * c);
    const double pz = c * std::sqrt(std::max(0.0, 1.0 - px * px - py * py));
    const double sine = radius > 0.0 ? std::min(1.0, pz / radius) : 0.0;
    return AxisTruth{ std::abs(p[2]), radius, degrees(2.0 * std::asin(sine)) };
  };
  return axis;
}

AnalyticAxis eccentricShell()
{
  constexpr double kInner = 0.4;
  constexpr double kOuter = 1.0;
  const Point3 centre{ 0.17, 0.05, -0.08 };
  AnalyticAxis axis;
  axis.shape = [centre](double h)
  {
    return appended(translated(icosphere(kOuter, subdivisions(h)), centre),
      flipOrientation(icosphere(kInner, subdivisions(h))));
  };
  axis.bounds = around({ 1.3, 1.2, 1.2 });
  axis.spacing = 0.08;
  axis.angle = 90.0;
  axis.truth = [centre](const Point3& p)
  {
    const Point3 q = minus(p, centre);
    const double toInner = length(p);
    const double toOuter = length(q);
    const double cosine = dot(p, q) / (toInner * toOuter);
    const double gradient = std::sqrt(2.0 + 2.0 * cosine);
    return AxisTruth{ std::abs(toInner + toOuter - kInner - kOuter) / gradient, toInner - kInner,
      degrees(std::acos(std::clamp(-cosine, -1.0, 1.0))) };
  };
  return axis;
}

AnalyticAxis openPlates()
{
  constexpr double kGap = 0.6;
  constexpr double kHalfSide = 0.7;
  AnalyticAxis axis;
  axis.shape = [](double) { return plates(kGap, kHalfSide); };
  axis.bounds = around({ 0.95, 0.9, 0.25 });
  axis.spacing = 0.07;
  axis.angle = 60.0;
  axis.side = Side::Both;
  axis.truth = [](const Point3& p)
  {
    const double u = std::max(0.0, std::abs(p[0]) - kHalfSide);
    const double v = std::max(0.0, std::abs(p[1]) - kHalfSide);
    const double radius = std::hypot(0.5 * kGap, u, v);
    return AxisTruth{ std::abs(p[2]), radius, degrees(2.0 * std::asin(0.5 * kGap / radius)) };
  };
  return axis;
}

AnalyticAxis pointAndPlane()
{
  constexpr double kFocus = 0.35;
  AnalyticAxis axis;
  axis.shape = [](double)
  {
    constexpr double s = 4.0;
    return makeMesh({ { -s, -s, -kFocus }, { s, -s, -kFocus }, { s, s, -kFocus },
                      { -s, s, -kFocus }, { 0.0, 0.0, kFocus } },
      { { 0, 1, 2 }, { 0, 2, 3 } }, {}, { 4 });
  };
  axis.bounds = around({ 0.8, 0.75, 0.9 });
  axis.spacing = 0.07;
  axis.angle = 60.0;
  axis.side = Side::Both;
  axis.truth = [](const Point3& p)
  {
    const double rho = std::hypot(p[0], p[1]);
    const double slope = 0.5 * rho / kFocus;
    const Point3 below{ p[0], p[1], -kFocus };
    return AxisTruth{ std::abs(p[2] - 0.25 * rho * rho / kFocus) / std::hypot(1.0, slope),
      p[2] + kFocus, angleAt(p, { 0.0, 0.0, kFocus }, below) };
  };
  return axis;
}

AnalyticAxis skewLines()
{
  constexpr double k = 0.4;
  AnalyticAxis axis;
  axis.shape = [](double)
  {
    constexpr double s = 5.0;
    return makeMesh({ { -s, 0.0, k }, { s, 0.0, k }, { 0.0, -s, -k }, { 0.0, s, -k } }, {},
      { { 0, 1 }, { 2, 3 } });
  };
  axis.bounds = around({ 0.8, 0.85, 0.9 });
  axis.spacing = 0.07;
  axis.angle = 50.0;
  axis.side = Side::Both;
  axis.truth = [](const Point3& p)
  {
    const double residual = p[2] - (p[1] * p[1] - p[0] * p[0]) / (4.0 * k);
    const double gradient = std::hypot(1.0, 0.5 * p[0] / k, 0.5 * p[1] / k);
    return AxisTruth{ std::abs(residual) / gradient, std::hypot(p[1], p[2] - k),
      angleAt(p, { p[0], 0.0, k }, { 0.0, p[1], -k }) };
  };
  return axis;
}

AnalyticAxis convexWedge()
{
  constexpr double kDihedral = 70.0;
  AnalyticAxis axis;
  axis.shape = [](double) { return wedge(kDihedral, 6.0, 4.0); };
  axis.bounds.min = { 0.05, -0.3, -0.4 };
  axis.bounds.max = { 0.9, 0.3, 0.4 };
  axis.spacing = 0.05;
  axis.angle = 100.0;
  axis.truth = [](const Point3& p)
  {
    return AxisTruth{ std::abs(p[1]), p[0] * std::sin(0.5 * kDihedral * kPi / 180.0),
      180.0 - kDihedral };
  };
  return axis;
}

Grid gridOf(const AnalyticAxis& axis, double spacing)
{
  Grid grid;
  grid.spacing = { spacing, spacing, spacing };
  for (int i = 0; i < 3; ++i)
  {
    // No round places.
    const double shift = (0.137 + 0.171 * i) * spacing;
    grid.origin[i] = axis.bounds.min[i] + shift;
    grid.dimensions[i] =
      static_cast<int>((axis.bounds.max[i] - axis.bounds.min[i] - shift) / spacing) + 1;
  }
  return grid;
}

} // namespace

std::vector<Named<AnalyticAxis>> analyticAxes()
{
  std::vector<Named<AnalyticAxis>> axes = analyticSolids();
  axes.insert(axes.end(),
    { { "ellipsoid", triaxialEllipsoid }, { "eccentricShell", eccentricShell },
      { "plates", openPlates }, { "pointAndPlane", pointAndPlane }, { "skewLines", skewLines },
      { "wedge", convexWedge } });
  return axes;
}

AnalyticErrors analyticErrors(const AnalyticAxis& axis, double spacing)
{
  MedialAxisOptions options;
  options.angle = axis.angle;
  options.side = axis.side;
  const MedialAxis found = computeMedialAxis(axis.shape(spacing), gridOf(axis, spacing), options);
  AnalyticErrors errors;
  for (std::size_t p = 0; p < found.points.size(); ++p)
  {
    if (!axis.regular(found.points[p], spacing))
    {
      continue;
    }
    const AxisTruth truth = axis.truth(found.points[p]);
    const double position = truth.offAxis / spacing;
    const double radius = std::abs(static_cast<double>(found.radius[p]) - truth.radius) / spacing;
    const double angle = std::abs(static_cast<double>(found.separationAngle[p]) - truth.angle);
    ++errors.points;
    errors.positionMax = std::max(errors.positionMax, position);
    errors.positionMean += position;
    errors.radiusMax = std::max(errors.radiusMax, radius);
    errors.radiusMean += radius;
    errors.angleMax = std::max(errors.angleMax, angle);
    errors.angleMean += angle;
  }
  const double count = static_cast<double>(std::max<std::size_t>(1, errors.points));
  errors.positionMean /= count;
  errors.radiusMean /= count;
  errors.angleMean /= count;
  errors.area = axis.area > 0.0 ? std::abs(areaOf(found) / axis.area - 1.0) : 0.0;
  return errors;
}

} // namespace medial::test

#include "support/medial_checks.h"

#include "support/brute_force.h"
#include "support/point_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace medial::test
{

namespace
{

Point3 widened(const std::array<float, 3>& p)
{
  return { static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) };
}

double maximum(const std::vector<double>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void expectOneAttributePerPoint(const MedialAxis& axis)
{
  const std::size_t count = axis.points.size();
  EXPECT_EQ(axis.radius.size(), count);
  EXPECT_EQ(axis.separationAngle.size(), count);
  EXPECT_EQ(axis.lambda.size(), count);
  EXPECT_EQ(axis.closestPointA.size(), count);
  EXPECT_EQ(axis.closestPointB.size(), count);
}

double voxelSize(const Grid& grid)
{
  return std::min({ grid.spacing[0], grid.spacing[1], grid.spacing[2] });
}

/// What storing closest points in single precision may move them by.
double coordinateRounding(const TriangleMesh& mesh)
{
  double largest = 0.0;
  for (const Point3& p : mesh.points)
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return largest * static_cast<double>(std::numeric_limits<float>::epsilon());
}

void expectExactRadii(const TriangleMesh& mesh, const Grid& grid, const MedialAxis& axis,
  Representation representation)
{
  const double h = voxelSize(grid);
  const double rounding = coordinateRounding(mesh) / h;
  const double diagonal = length(grid.spacing) / h;
  const std::vector<Hit> truth = closestOnMesh(mesh, axis.points);
  std::vector<double> radius;
  std::vector<double> toA;
  std::vector<double> toB;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    const Point3& x = axis.points[i];
    const double r = truth[i].distance;
    radius.push_back(std::abs(static_cast<double>(axis.radius[i]) - r) / h);
    toA.push_back(std::abs(length(minus(widened(axis.closestPointA[i]), x)) - r) / h);
    toB.push_back(std::abs(length(minus(widened(axis.closestPointB[i]), x)) - r) / h);
  }
  EXPECT_LE(maximum(radius), 1e-3);
  EXPECT_LE(maximum(toA), 1e-3 + rounding);
  EXPECT_LE(maximum(toB), representation == Representation::Points ? 0.1 + rounding : diagonal);
  if (representation == Representation::Surface)
  {
    const auto far = std::count_if(toB.begin(), toB.end(), [](double d) { return d > 1.0; });
    EXPECT_LE(static_cast<double>(far), 0.01 * static_cast<double>(toB.size()));
  }
}

void expectClosestPointsOnSurface(const TriangleMesh& mesh, double tolerance,
  const MedialAxis& axis)
{
  std::vector<Point3> points;
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    points.push_back(widened(axis.closestPointA[i]));
    points.push_back(widened(axis.closestPointB[i]));
  }
  double most = 0.0;
  for (const Hit& hit : closestOnMesh(mesh, points))
  {
    most = std::max(most, hit.distance);
  }
  EXPECT_LE(most, tolerance);
}

void expectAngles(double h, double rounding, const MedialAxis& axis)
{
  double worstLambda = 0.0;
  double worstAngle = 0.0;
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    const double angle = static_cast<double>(axis.separationAngle[i]);
    const double radius = static_cast<double>(axis.radius[i]);
    const double lambda = radius * std::sin(0.5 * angle * kPi / 180.0);
    worstLambda = std::max(worstLambda, std::abs(lambda - static_cast<double>(axis.lambda[i])));
    // The closest points are rounded to single precision, which matters at small radii.
    if (radius > 1e-2 * h && radius > 2000.0 * rounding)
    {
      const double seen =
        degrees(angleBetween(minus(widened(axis.closestPointA[i]), axis.points[i]),
          minus(widened(axis.closestPointB[i]), axis.points[i])));
      worstAngle = std::max(worstAngle, std::abs(seen - angle));
    }
    EXPECT_TRUE(angle >= 0.0 && angle <= 180.001) << "angle " << angle;
  }
  EXPECT_LE(worstLambda, 1e-4 * h);
  EXPECT_LE(worstAngle, 0.1);
}

/// The corners of all cells, in one list each.
std::vector<std::vector<std::int64_t>> cellCorners(const MedialAxis& axis)
{
  std::vector<std::vector<std::int64_t>> cells;
  const auto add = [&](const auto& list)
  {
    for (const auto& cell : list)
    {
      cells.emplace_back(cell.begin(), cell.end());
    }
  };
  add(axis.quads);
  add(axis.triangles);
  add(axis.lines);
  for (const std::int64_t vertex : axis.vertices)
  {
    cells.push_back({ vertex });
  }
  return cells;
}

/// Area of a polygon, length of a line, nothing for a vertex.
double extent(const std::vector<Point3>& points, const std::vector<std::int64_t>& cell)
{
  if (cell.size() == 2)
  {
    return length(minus(points[cell[0]], points[cell[1]]));
  }
  Point3 twice{};
  for (std::size_t i = 2; i < cell.size(); ++i)
  {
    const Point3 c =
      cross(minus(points[cell[i - 1]], points[cell[0]]), minus(points[cell[i]], points[cell[0]]));
    twice = { twice[0] + c[0], twice[1] + c[1], twice[2] + c[2] };
  }
  return 0.5 * length(twice);
}

void expectSoundCells(const MedialAxis& axis)
{
  std::vector<char> used(axis.points.size(), 0);
  std::set<std::vector<std::int64_t>> known;
  int repeated = 0;
  int flat = 0;
  int twice = 0;
  for (const std::vector<std::int64_t>& cell : cellCorners(axis))
  {
    for (const std::int64_t corner : cell)
    {
      used.at(corner) = 1;
    }
    std::vector<std::int64_t> sorted = cell;
    std::sort(sorted.begin(), sorted.end());
    repeated += std::unique(sorted.begin(), sorted.end()) == sorted.end() ? 0 : 1;
    flat += cell.size() > 1 && !(extent(axis.points, cell) > 0.0) ? 1 : 0;
    twice += cell.size() <= 2 && !known.insert(sorted).second ? 1 : 0;
  }
  EXPECT_EQ(repeated, 0) << "cells with a repeated corner";
  EXPECT_EQ(flat, 0) << "cells without area or length";
  EXPECT_EQ(twice, 0) << "duplicate lines or vertices";
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0) << "unused points";
}

} // namespace

Grid offCentreGrid(const TriangleMesh& mesh, double spacing, double margin)
{
  const Bounds bounds = mesh.bounds();
  const double shift[3] = { 0.37, 0.43, 0.29 };
  Grid grid;
  grid.spacing = { spacing, spacing, spacing };
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.origin[axis] = bounds.min[axis] - margin - shift[axis] * spacing;
    const double size = bounds.max[axis] + margin - grid.origin[axis];
    grid.dimensions[axis] = static_cast<int>(std::ceil(size / spacing)) + 1;
  }
  return grid;
}

void expectConsistent(const TriangleMesh& mesh, const Grid& grid, const MedialAxis& axis,
  Representation representation)
{
  const double h = voxelSize(grid);
  const double rounding = coordinateRounding(mesh);
  EXPECT_GT(axis.points.size(), 0u);
  expectOneAttributePerPoint(axis);
  expectExactRadii(mesh, grid, axis, representation);
  expectClosestPointsOnSurface(mesh, 1e-3 * h + rounding, axis);
  expectAngles(h, rounding, axis);
  expectSoundCells(axis);
}

std::vector<Point3> cellCentres(const MedialAxis& axis)
{
  std::vector<Point3> centres;
  for (const std::vector<std::int64_t>& cell : cellCorners(axis))
  {
    Point3 centre{};
    for (const std::int64_t corner : cell)
    {
      for (int i = 0; i < 3; ++i)
      {
        centre[i] += axis.points[corner][i] / static_cast<double>(cell.size());
      }
    }
    if (cell.size() > 2)
    {
      centres.push_back(centre);
    }
  }
  return centres;
}

double thickening(double spacing, double angle)
{
  return spacing / (2.0 * std::sin(0.5 * angle * kPi / 180.0)) + 0.5 * spacing;
}

std::vector<Point3> randomPointsOn(const TriangleMesh& mesh, int count, std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto mix = [](const Point3& a, const Point3& b, double t) -> Point3 {
    return { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]) };
  };
  std::vector<double> sizes;
  for (const auto& t : mesh.triangles)
  {
    const Point3& a = mesh.points[t[0]];
    sizes.push_back(length(cross(minus(mesh.points[t[1]], a), minus(mesh.points[t[2]], a))) + 1e-9);
  }
  std::vector<Point3> points;
  std::discrete_distribution<std::size_t> pick(sizes.begin(), sizes.end());
  for (int i = 0; i < count && !mesh.triangles.empty(); ++i)
  {
    const auto& t = mesh.triangles[pick(random)];
    const Point3 side = mix(mesh.points[t[1]], mesh.points[t[2]], share());
    points.push_back(mix(mesh.points[t[0]], side, std::sqrt(share())));
  }
  for (int i = 0; i < count && !mesh.segments.empty(); ++i)
  {
    const auto& s = mesh.segments[random() % mesh.segments.size()];
    points.push_back(mix(mesh.points[s[0]], mesh.points[s[1]], share()));
  }
  for (const int vertex : mesh.vertices)
  {
    points.push_back(mesh.points[vertex]);
  }
  return points;
}

std::vector<double> distancesToPoints(const std::vector<Point3>& points,
  const std::vector<Point3>& others)
{
  std::vector<double> distances(points.size(), std::numeric_limits<double>::infinity());
  parallelFor(points.size(),
    [&](std::size_t i)
    {
      for (const Point3& other : others)
      {
        distances[i] = std::min(distances[i], length(minus(points[i], other)));
      }
    });
  return distances;
}

AxisErrors axisErrors(const MedialTruth& truth, const std::vector<Point3>& points, double thickness)
{
  const std::vector<Hit> toAxis = closestOnMesh(truth.axis, points);
  const std::vector<Hit> toCurves = closestOnMesh(truth.curves, points);
  AxisErrors errors;
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (toCurves[i].distance <= thickness)
    {
      errors.curveMax = std::max(errors.curveMax, toAxis[i].distance);
      continue;
    }
    ++errors.onSheets;
    sum += toAxis[i].distance;
    errors.sheetMax = std::max(errors.sheetMax, toAxis[i].distance);
  }
  errors.sheetMean = errors.onSheets > 0 ? sum / static_cast<double>(errors.onSheets) : 0.0;
  return errors;
}

double uncovered(const MedialTruth& truth, const std::vector<Point3>& points, double margin)
{
  const std::vector<Point3> places = randomPointsOn(truth.axis, 2000);
  const std::vector<Hit> toSurface = closestOnMesh(truth.shape, places);
  std::vector<Point3> deep;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (toSurface[i].distance > margin)
    {
      deep.push_back(places[i]);
    }
  }
  EXPECT_FALSE(deep.empty());
  return maximum(distancesToPoints(deep, points));
}

} // namespace medial::test

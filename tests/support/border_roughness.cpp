#include "support/border_roughness.h"

#include "medial/axis_curves.h"

#include "support/point_math.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace medial::test
{
namespace
{

constexpr double kMinLength = 20.0; // voxels
constexpr double kWindow = 5.0;     // voxels
constexpr int kSamplesPerVoxel = 4;

/// Points at equal steps along a polyline, the first one included.
std::vector<Point3> evenlySpaced(const std::vector<Point3>& polyline, double step)
{
  std::vector<Point3> samples{ polyline.front() };
  double left = step;
  for (std::size_t i = 1; i < polyline.size(); ++i)
  {
    const Point3& p = polyline[i - 1];
    const Point3& q = polyline[i];
    const double length = distance(p, q);
    double at = left;
    for (; at <= length; at += step)
    {
      const double t = at / length;
      samples.push_back(
        { p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2]) });
    }
    left = at - length;
  }
  return samples;
}

double lengthOf(const std::vector<Point3>& polyline, std::size_t begin, std::size_t end)
{
  double length = 0.0;
  for (std::size_t i = begin + 1; i < end; ++i)
  {
    length += distance(polyline[i - 1], polyline[i]);
  }
  return length;
}

/// Means over windows of 2 * half + 1 points.
std::vector<Point3> movingAverage(const std::vector<Point3>& points, std::size_t half)
{
  std::vector<Point3> means;
  for (std::size_t i = half; i + half < points.size(); ++i)
  {
    Point3 sum{};
    for (std::size_t k = i - half; k <= i + half; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += points[k][axis] / static_cast<double>(2 * half + 1);
      }
    }
    means.push_back(sum);
  }
  return means;
}

} // namespace

Borders bordersOf(const MedialAxis& axis, double voxel)
{
  Borders borders;
  for (const AxisCurve& curve : axisCurves(edgesOf(axis), axis.points.size()))
  {
    std::vector<Point3> polyline;
    for (const std::int64_t p : curve.points)
    {
      polyline.push_back(axis.points[p]);
    }
    if (curve.kind != AxisFeature::Rim ||
      lengthOf(polyline, 0, polyline.size()) < kMinLength * voxel)
    {
      continue;
    }
    const std::vector<Point3> samples = evenlySpaced(polyline, voxel / kSamplesPerVoxel);
    const auto half = static_cast<std::size_t>(0.5 * kWindow * kSamplesPerVoxel);
    const std::vector<Point3> means = movingAverage(samples, half);
    borders.length += lengthOf(samples, half, samples.size() - half);
    borders.averaged += lengthOf(means, 0, means.size());
  }
  return borders;
}

} // namespace medial::test

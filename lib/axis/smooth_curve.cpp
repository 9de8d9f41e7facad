#include "axis/smooth_curve.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

glm::dvec3 unit(const glm::dvec3& vector)
{
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

/// Returns value and derivative at 0 of the parabola nearest to points at whole numbers.
/// @param at returns the point at a number in [low, high].
template <typename At>
CurvePoint fitParabola(int low, int high, int reach, const At& at)
{
  double moments[5]{};
  glm::dvec3 sums[3]{ glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0) };
  for (int k = low; k <= high; ++k)
  {
    const double s = static_cast<double>(k) / (reach + 1);
    const double cube = std::abs(s * s * s);
    const double weight = (1.0 - cube) * (1.0 - cube) * (1.0 - cube);
    double power = weight;
    for (int m = 0; m < 5; ++m)
    {
      moments[m] += power;
      if (m < 3)
      {
        sums[m] += power * at(k);
      }
      power *= s;
    }
  }
  const glm::dmat3 normal(moments[0], moments[1], moments[2], moments[1], moments[2], moments[3],
    moments[2], moments[3], moments[4]);
  const glm::dmat3 inverse = glm::inverse(normal);
  const auto coefficient = [&](int row)
  { return inverse[0][row] * sums[0] + inverse[1][row] * sums[1] + inverse[2][row] * sums[2]; };
  return { coefficient(0), unit(coefficient(1)) };
}

} // namespace

void reverse(Curve& curve)
{
  std::reverse(curve.points.begin(), curve.points.end());
  std::reverse(curve.widths.begin(), curve.widths.end());
  std::reverse(curve.radii.begin(), curve.radii.end());
}

void dropLast(Curve& curve)
{
  curve.points.pop_back();
  for (std::vector<double>* values : { &curve.widths, &curve.radii })
  {
    if (!values->empty())
    {
      values->pop_back();
    }
  }
}

void join(Curve& curve, const Curve& next)
{
  const auto append = [](auto& values, const auto& others)
  {
    if (values.empty() || others.empty())
    {
      values.clear();
      return;
    }
    values.insert(values.end(), others.begin() + 1, others.end());
  };
  append(curve.points, next.points);
  append(curve.widths, next.widths);
  append(curve.radii, next.radii);
}

std::vector<double> arcLengths(const Curve& curve)
{
  std::vector<double> lengths{ 0.0 };
  const std::size_t count = curve.points.size();
  for (std::size_t i = 1; i < count + (curve.closed ? 1 : 0); ++i)
  {
    lengths.push_back(lengths.back() + glm::distance(curve.points[i - 1], curve.points[i % count]));
  }
  return lengths;
}

Curve resampled(const Curve& curve, double step)
{
  const std::vector<double> lengths = arcLengths(curve);
  const int parts =
    std::max(curve.closed ? 3 : 1, static_cast<int>(std::lround(lengths.back() / step)));
  const std::size_t count = curve.points.size();
  Curve result;
  result.closed = curve.closed;
  std::size_t at = 0;
  for (int i = 0; i < parts; ++i)
  {
    const double length = lengths.back() * i / parts;
    while (at + 2 < lengths.size() && lengths[at + 1] <= length)
    {
      ++at;
    }
    const double part = lengths[at + 1] - lengths[at];
    const double share = part > 0.0 ? (length - lengths[at]) / part : 0.0;
    const std::size_t next = (at + 1) % count;
    result.points.push_back(glm::mix(curve.points[at], curve.points[next], share));
    if (!curve.widths.empty())
    {
      result.widths.push_back(glm::mix(curve.widths[at], curve.widths[next], share));
    }
  }
  if (!curve.closed)
  {
    result.points.push_back(curve.points.back());
    if (!curve.widths.empty())
    {
      result.widths.push_back(curve.widths.back());
    }
  }
  return result;
}

CurvePoint smoothedAt(const Curve& curve, std::size_t point, int reach)
{
  const int count = static_cast<int>(curve.points.size());
  const int i = static_cast<int>(point);
  int low = -reach;
  int high = reach;
  if (curve.closed)
  {
    reach = std::min(reach, (count - 1) / 2);
    low = -reach;
    high = reach;
  }
  else
  {
    low = std::max(low, -i);
    high = std::min(high, count - 1 - i);
  }
  if (high - low < 3)
  {
    const glm::dvec3 before = curve.points[(i + count + low) % count];
    const glm::dvec3 after = curve.points[(i + high) % count];
    return { curve.points[i], unit(after - before) };
  }
  return fitParabola(low, high, reach,
    [&](int k) { return curve.points[(i + k + count) % count]; });
}

std::vector<CurvePoint> smoothed(const Curve& curve, const std::vector<int>& reaches)
{
  std::vector<CurvePoint> result;
  for (std::size_t i = 0; i < curve.points.size(); ++i)
  {
    result.push_back(smoothedAt(curve, i, reaches[i]));
  }
  return result;
}

std::vector<glm::dvec3> tangentsOf(const Curve& curve)
{
  const int count = static_cast<int>(curve.points.size());
  std::vector<glm::dvec3> tangents;
  for (int i = 0; i < count; ++i)
  {
    const int before = curve.closed ? (i + count - 1) % count : std::max(0, i - 1);
    const int after = curve.closed ? (i + 1) % count : std::min(count - 1, i + 1);
    tangents.push_back(unit(curve.points[after] - curve.points[before]));
  }
  return tangents;
}

} // namespace medial

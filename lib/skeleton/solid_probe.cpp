#include "skeleton/solid_probe.h"

#include "axis/widest_place.h"
#include "base/vectors.h"

#include <Eigen/Dense>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace medial
{
namespace
{

/// How far away from a point its surroundings are asked for, as a part of its radius.
constexpr double kReach = 0.5;
/// Keeps the centre where it is as long as nothing tells where it should be.
constexpr double kInertia = 0.02;
/// A centre moves by at most this part of the radius.
constexpr double kMaxMove = 0.5;

/// Returns the centre of the circle or ball with the smallest algebraic error (Kasa 1976).
template <int N, std::size_t Count>
Eigen::Matrix<double, N, 1> centreOf(const std::array<Eigen::Matrix<double, N, 1>, Count>& samples)
{
  Eigen::Matrix<double, N + 1, N + 1> normal = Eigen::Matrix<double, N + 1, N + 1>::Zero();
  Eigen::Matrix<double, N + 1, 1> right = Eigen::Matrix<double, N + 1, 1>::Zero();
  for (const auto& sample : samples)
  {
    Eigen::Matrix<double, N + 1, 1> row;
    row << 2.0 * sample, 1.0;
    normal += row * row.transpose();
    right += sample.squaredNorm() * row;
  }
  normal.diagonal().template head<N>().array() += kInertia * static_cast<double>(Count);
  Eigen::Matrix<double, N, 1> centre = normal.ldlt().solve(right).template head<N>();
  const double length = centre.norm();
  return length > kMaxMove ? (centre * (kMaxMove / length)).eval() : centre;
}

} // namespace

double SolidProbe::radius(const glm::dvec3& x) const
{
  return glm::distance(query_.query().closest(x).point, x);
}

std::vector<double> SolidProbe::radii(const std::vector<glm::dvec3>& points) const
{
  std::vector<double> radii(points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size()),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      Search near = this->search();
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        radii[i] = glm::distance(near.closest(points[i]).point, points[i]);
      }
    });
  return radii;
}

glm::dvec3 SolidProbe::closest(const glm::dvec3& x) const
{
  return query_.query().closest(x).point;
}

bool SolidProbe::inside(const glm::dvec3& x) const
{
  PointSide::Known known;
  return query_.side().contains(x, query_.query().closest(x), known);
}

double SolidProbe::wayOut(const glm::dvec3& from, const glm::dvec3& direction, double high) const
{
  constexpr int kParts = 8;
  constexpr double kPrecision = 1e-5;
  const double precision = kPrecision * high;
  // Through an opening the way may leave the solid far from the surface.
  const double farthest = query_.side().changesOnlyAtSurface() ? high : high / kParts;
  Search search = this->search();
  PointSide::Known known;
  // From ball to ball, so that no gap is passed over.
  double in = 0.0;
  double out = 0.0;
  double distance = 0.0;
  const auto isInside = [&](double length)
  {
    const glm::dvec3 x = from + length * direction;
    const SitePoint& closest = search.closest(x);
    distance = glm::distance(closest.point, x);
    return query_.side().contains(x, closest, known);
  };
  while (isInside(out))
  {
    in = out;
    if (in >= high)
    {
      return high;
    }
    out = std::min(high, in + std::clamp(distance, precision, farthest));
  }
  while (out - in > precision)
  {
    const double middle = 0.5 * (in + out);
    (isInside(middle) ? in : out) = middle;
  }
  return in;
}

glm::dvec3 SolidProbe::widestAcross(Search& search, const glm::dvec3& x, const glm::dvec3& tangent,
  double precision)
{
  return widestPlace(x, tangent, precision,
    [&](const glm::dvec3& place) { return search.closest(place).point; });
}

glm::dvec3 SolidProbe::middleAcross(Search& search, const glm::dvec3& x, const glm::dvec3& tangent)
{
  constexpr std::size_t kDirections = 8;
  const double radius = glm::distance(search.closest(x).point, x);
  if (!(radius > 0.0) || tangent == glm::dvec3(0.0))
  {
    return x;
  }
  const auto [u, v] = normalsTo(tangent);
  std::array<Eigen::Vector2d, kDirections> samples;
  for (std::size_t k = 0; k < kDirections; ++k)
  {
    const double angle = glm::radians(360.0) * static_cast<double>(k) / kDirections;
    const glm::dvec3 offset = kReach * radius * (std::cos(angle) * u + std::sin(angle) * v);
    const glm::dvec3 seen = (search.closest(x + offset).point - x) / radius;
    samples[k] = { glm::dot(seen, u), glm::dot(seen, v) };
  }
  const Eigen::Vector2d centre = centreOf<2>(samples);
  return x + radius * (centre.x() * u + centre.y() * v);
}

glm::dvec3 SolidProbe::middle(const glm::dvec3& x) const
{
  const double radius = this->radius(x);
  if (!(radius > 0.0))
  {
    return x;
  }
  std::array<Eigen::Vector3d, 6> samples;
  for (int k = 0; k < 6; ++k)
  {
    glm::dvec3 offset(0.0);
    offset[k / 2] = k % 2 == 0 ? kReach * radius : -kReach * radius;
    const glm::dvec3 seen = (query_.query().closest(x + offset).point - x) / radius;
    samples[k] = { seen.x, seen.y, seen.z };
  }
  const Eigen::Vector3d centre = centreOf<3>(samples);
  return x + radius * glm::dvec3(centre.x(), centre.y(), centre.z());
}

} // namespace medial

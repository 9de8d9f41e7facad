#include "axis/plane_fit.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace medial
{
namespace
{

/// Directions with less than this share of the largest eigenvalue are undetermined: normals within
/// some 17 degrees of each other belong to one curved sheet.
constexpr double kMinShare = 0.08;

/// Returns the point nearest to `point` on a line through it with |x - centre| <= reach along every
/// axis.
std::optional<glm::dvec3> slid(const glm::dvec3& point, const glm::dvec3& along,
  const glm::dvec3& centre, const glm::dvec3& reach)
{
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double offset = centre[axis] - point[axis];
    if (along[axis] == 0.0)
    {
      if (std::abs(offset) > reach[axis])
      {
        return std::nullopt;
      }
      continue;
    }
    const double one = (offset - reach[axis]) / along[axis];
    const double other = (offset + reach[axis]) / along[axis];
    min = std::max(min, std::min(one, other));
    max = std::min(max, std::max(one, other));
  }
  return min <= max ? std::optional(point + std::clamp(0.0, min, max) * along) : std::nullopt;
}

} // namespace

void PlaneFit::clear()
{
  planes_.clear();
  mean_ = glm::dvec3(0.0);
}

void PlaneFit::add(const glm::dvec3& point, const glm::dvec3& unitNormal, double weight)
{
  planes_.push_back({ point, unitNormal, weight });
  mean_ += (point - mean_) / static_cast<double>(planes_.size());
}

glm::dvec3 PlaneFit::solve(const glm::dvec3& centre, const glm::dvec3& reach) const
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Plane& plane : planes_)
  {
    const Eigen::Vector3d normal(plane.normal.x, plane.normal.y, plane.normal.z);
    squares += plane.weight * normal * normal.transpose();
    right += plane.weight * glm::dot(plane.normal, plane.point - mean_) * normal;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(squares);
  const Eigen::Vector3d& values = eigen.eigenvalues(); // ascending
  int first = 0;
  while (first < 3 && values[first] < kMinShare * values[2])
  {
    ++first;
  }
  for (; first < 3; ++first)
  {
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    for (int i = first; i < 3 && values[i] > 0.0; ++i)
    {
      const Eigen::Vector3d direction = eigen.eigenvectors().col(i);
      offset += direction.dot(right) / values[i] * direction;
    }
    const glm::dvec3 point = mean_ + glm::dvec3(offset[0], offset[1], offset[2]);
    if (first == 1)
    {
      const Eigen::Vector3d seam = eigen.eigenvectors().col(0);
      if (const auto onSeam = slid(point, { seam[0], seam[1], seam[2] }, centre, reach))
      {
        return *onSeam;
      }
      continue;
    }
    if (glm::all(glm::lessThanEqual(glm::abs(point - centre), reach)))
    {
      return point;
    }
  }
  return mean_;
}

} // namespace medial

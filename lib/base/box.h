#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace medial
{

/// As std::max(), which branches; this becomes one instruction.
inline double larger(double x, double y)
{
  return x > y ? x : y;
}

inline double smaller(double x, double y)
{
  return x < y ? x : y;
}

/// An axis-aligned box.
struct Box
{
  /// Boxes may be farther apart than what is in them by rounding: bounds times this are safe.
  static constexpr double kRoundedUp = 1.0 + 1e-12;

  glm::dvec3 min{ std::numeric_limits<double>::infinity() };
  glm::dvec3 max{ -std::numeric_limits<double>::infinity() };

  void add(const glm::dvec3& low, const glm::dvec3& high)
  {
    min = { smaller(min.x, low.x), smaller(min.y, low.y), smaller(min.z, low.z) };
    max = { larger(max.x, high.x), larger(max.y, high.y), larger(max.z, high.z) };
  }
  void add(const glm::dvec3& point) { this->add(point, point); }
  void add(const Box& other) { this->add(other.min, other.max); }

  Box moved(const glm::dvec3& translation) const
  {
    return { min + translation, max + translation };
  }
  glm::dvec3 size() const { return max - min; }
  bool overlaps(const Box& other) const
  {
    return min.x <= other.max.x && other.min.x <= max.x && min.y <= other.max.y &&
      other.min.y <= max.y && min.z <= other.max.z && other.min.z <= max.z;
  }
  bool contains(const glm::dvec3& point) const { return this->overlaps({ point, point }); }
  double squaredDistance(const Box& other) const
  {
    const auto gap = [&](int axis)
    { return larger(larger(other.min[axis] - max[axis], min[axis] - other.max[axis]), 0.0); };
    const double x = gap(0);
    const double y = gap(1);
    const double z = gap(2);
    return x * x + y * y + z * z;
  }
  double squaredDistance(const glm::dvec3& point) const
  {
    return this->squaredDistance(Box{ point, point });
  }
};

} // namespace medial

#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace medial
{

/// One over 4 pi.
constexpr double kPerSphere = 0.0795774715459476678844;

/// Bounds of a value.
struct Interval
{
  double low;
  double high;

  bool contains(double value) const { return low <= value && value <= high; }
};

/// Winding numbers in a ball: a quadratic function, and the largest difference from it.
struct LocalExpansion
{
  glm::dvec3 centre{ 0.0 };
  double radius = 0.0;
  double value = 0.0; ///< at the centre
  glm::dvec3 gradient{ 0.0 };
  glm::dmat3 hessian{ 0.0 }; ///< symmetric
  double error = 0.0;

  double at(const glm::dvec3& point) const;
  /// Bounds the values in the ball.
  Interval bounds() const;
  /// Returns the same function around the centre of a ball inside this one.
  LocalExpansion movedTo(const glm::dvec3& newCentre, double newRadius) const;
};

/// Triangles as seen from afar: integrals of their area vectors times powers of the offset from
/// their middle. For the expansions see docs/design/sign.md.
struct Multipole
{
  glm::dvec3 middle{ 0.0 };
  double area = 0.0;
  glm::dvec3 areaVector{ 0.0 };
  glm::dmat3 first{ 0.0 }; ///< symmetric part
  std::array<glm::dmat3, 3> second{ glm::dmat3(0.0), glm::dmat3(0.0), glm::dmat3(0.0) };

  /// @param weight how often the triangle counts.
  static Multipole ofTriangle(const std::array<glm::dvec3, 3>& corners, int weight);
  /// Returns the multipole of two groups together.
  static Multipole ofBoth(const Multipole& a, const Multipole& b);

  /// Bounds the error of addTo().
  /// @param reach radius of the group around its middle plus that of the ball.
  double errorAt(double distance, double reach) const
  {
    const double gap = distance - reach;
    // The tail of the series.
    return gap > 0.0 ? kPerSphere * area * reach * reach * reach * (4.0 * distance - 3.0 * reach) /
        (distance * distance * distance * distance * gap * gap)
                     : HUGE_VAL;
  }
  /// Adds the group to an expansion, but for the error.
  void addTo(LocalExpansion& expansion) const;
};

/// Planes of a triangle that has an area: its own, and three through its edges that face outwards.
class TrianglePlanes
{
public:
  explicit TrianglePlanes(const std::array<glm::dvec3, 3>& corners);

  /// Returns a lower bound of the distance from a point.
  double distanceTo(const glm::dvec3& point) const;

private:
  std::array<std::array<double, 4>, 3> normals_; ///< x, y and z
  std::array<double, 4> distances_;              ///< from the origin
};

/// Bounds the error of ExpansionSum::addTriangle().
/// @param gap from the centre to the triangle, or less; may be negative.
/// @param radius of the ball.
inline double triangleError(double area, double gap, double radius)
{
  if (gap <= radius)
  {
    return HUGE_VAL;
  }
  // The integral of 1 / distance^2 over the triangle, or that of radius^3 / distance^5 over its
  // plane, times the tail of the series.
  const double square = gap * gap;
  const double integral = std::min(kPerSphere * area, square / 6.0);
  return integral * radius * radius * radius * (4.0 * gap - 3.0 * radius) /
    (square * square * (gap - radius) * (gap - radius));
}

/// Bounds the error of ExpansionSum::addEdge(): of the change from the centre to a point of the
/// ball.
/// @param gap from the centre to the edge, or less.
/// @param radius of the ball.
double edgeError(double length, double gap, double radius);

} // namespace medial

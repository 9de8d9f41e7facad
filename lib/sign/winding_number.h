#pragma once

#include "sign/closed_surface.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// Bounds of a value.
struct Interval
{
  double low;
  double high;

  bool contains(double value) const { return low <= value && value <= high; }
};

/// An affine function inside a ball, and the largest difference from it.
struct AffineBound
{
  glm::dvec3 centre{ 0.0 };
  double radius = 0.0;
  double value = 0.0; ///< at the centre
  glm::dvec3 gradient{ 0.0 };
  double error = 0.0;

  double at(const glm::dvec3& point) const { return value + glm::dot(gradient, point - centre); }
  /// Returns the largest difference from the value at the centre.
  double change() const { return error + glm::length(gradient) * radius; }
};

/// The generalised winding number of weighted triangles (Jacobson, Kavan, Sorkine-Hornung 2013):
/// the sum of their solid angles over 4 pi, 1 inside a closed surface that faces outwards and 0
/// outside. Groups of triangles count as one dipole each where this suffices (Barill et al. 2018).
/// The derivatives of the solid angle's kernel y / |y|^3 bound the error: the length of the first
/// is sqrt(6) / |y|^3, that of the second at most 6 / |y|^4. Several threads may query it at once.
class WindingNumber
{
public:
  explicit WindingNumber(TriangleChain chain);

  /// Bounds the value at a point.
  /// @param tolerance largest error of a group that counts as one; 0 to sum all triangles one by
  ///   one.
  Interval bounds(const glm::dvec3& point, double tolerance) const;

  /// Returns the value at a point, to at least this precision.
  double at(const glm::dvec3& point, double precision) const;

  /// Whether the value at a point is above 1/2. Bounds are refined until they tell; near a half all
  /// triangles are summed one by one.
  bool isAboveHalf(const glm::dvec3& point) const;

  /// Adds the values in a ball, all triangles as one dipole. Returns false, and adds nothing, if
  /// the error could be above the tolerance.
  bool addDipole(double tolerance, AffineBound& sum) const;

  /// Whether a triangle may meet a ball.
  bool mayMeet(const glm::dvec3& centre, double radius) const;

private:
  /// A group of triangles, with the group that follows if this one is not opened. Groups are stored
  /// in the order of a descent.
  struct Node
  {
    glm::dvec3 middle{ 0.0 };
    double radius = 0.0;
    glm::dvec3 areaVector{ 0.0 };
    double area = 0.0;
    double moment = 0.0; ///< length of the sum of area vectors times their offsets from the middle
    int next = 0;
    int triangle = -1; ///< of a leaf
  };

  struct Dipole;

  int build(int* begin, int* end);
  glm::dvec3 areaVector(const WeightedTriangle& triangle) const;
  glm::dvec3 middle(int triangle) const;
  void measure(const int* begin, const int* end, Node& node) const;
  static double dipoleError(const Node& node, double gap, double radius);

  TriangleChain chain_;
  std::vector<Node> nodes_;
};

/// Returns the solid angle of a triangle over 4 pi, in [-0.5, 0.5]; positive where the corners run
/// clockwise, as from inside a surface that faces outwards (van Oosterom, Strackee 1983).
double solidAngle(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& from);

} // namespace medial

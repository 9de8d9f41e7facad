#pragma once

#include "sign/closed_surface.h"
#include "sign/continuation.h"
#include "sign/expansion_sum.h"
#include "sign/local_expansion.h"
#include "sign/solid_angle.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <vector>

namespace medial
{

/// The generalised winding number of weighted triangles (Jacobson, Kavan, Sorkine-Hornung 2013):
/// the sum of their solid angles over 4 pi, 1 inside a closed surface that faces outwards and 0
/// outside. Groups of triangles that are far count as multipoles (after Barill et al. 2018), single
/// ones by a Taylor series, each with a bound of the error. Several threads may query it at once.
class WindingNumber
{
public:
  explicit WindingNumber(const TriangleChain& chain);

  /// Finds the triangles that share edges, without which no view is continued.
  void joinTriangles();

  /// What is known in a ball: a quadratic function for what is far, and the rest.
  struct View
  {
    LocalExpansion far;
    std::vector<int> near;  ///< groups, and triangles as -1 - triangle
    double nearError = 0.0; ///< of the quadratic function if the rest counted as far, too
  };

  /// Returns the view of everything, in which all is near.
  View everything() const;
  /// Returns the view of a ball inside that of another view.
  /// @param tolerance largest error of a group or triangle that counts as far.
  View look(const View& outer, const glm::dvec3& centre, double radius, double tolerance) const;
  /// Returns a view in which only triangles are near; all of them if the tolerance is 0.
  View lookClosely(const View& outer, const glm::dvec3& centre, double radius,
    double tolerance) const;

  /// Bounds the values in the ball of a view; by infinity if anything is too near.
  Interval bounds(const View& view) const;
  /// Continues the values in the ball of a view through its near triangles; nothing if their border
  /// is too near, groups are near, or the triangles are not joined.
  std::optional<Continuation> continued(const View& view) const;
  /// Returns the values at points of the ball of a close view, to +- its far.error.
  SolidAngleSums::Values at(const View& view, const SolidAngleSums::Points& points) const;

  /// Bounds the value at a point.
  /// @param tolerance largest error of a group that counts as far; 0 to sum all triangles.
  Interval bounds(const glm::dvec3& point, double tolerance) const;
  /// Whether the value at a point is below a limit. Bounds are refined until they tell; near the
  /// limit all triangles are summed one by one.
  bool isBelow(double limit, const glm::dvec3& point) const;

private:
  struct Triangle
  {
    std::array<glm::dvec3, 3> corners;
    std::array<int, 3> points; ///< the corners' numbers
    int weight;
    glm::dvec3 middle;
    double radius; ///< around the middle
    double area;
  };
  /// A group of triangles that follow each other, in two halves unless it is a leaf.
  struct Group
  {
    Multipole multipole;
    double radius = 0.0; ///< around the multipole's middle
    int begin;
    int end;
    int half = 0; ///< second half; the first follows this group. 0 for a leaf
  };

  int build(int begin, int end);
  /// Adds the border of near triangles to a sum; returns its error, or a large one if it is large.
  double addBorder(const View& view, ExpansionSum& sum) const;
  /// Returns a lower bound of the distance to a triangle.
  double distanceTo(int triangle, const glm::dvec3& point) const;
  View look(const View& outer, const glm::dvec3& centre, double radius, double tolerance,
    bool closely) const;
  /// Returns the error of an item as far; if it is above the tolerance maybe infinity.
  double errorOf(int item, const LocalExpansion& far, double tolerance) const;
  bool isOpened(int item, double radius, bool closely) const;
  void add(int item, LocalExpansion& far, ExpansionSum& triangles) const;

  std::vector<Triangle> triangles_; ///< in the order of the groups
  std::vector<Group> groups_;
  std::vector<TrianglePlanes> planes_; ///< per triangle, if they are joined
  /// Per triangle: those beyond its edges, which count as often; -1 for none.
  std::vector<std::array<int, 3>> neighbours_;
};

} // namespace medial

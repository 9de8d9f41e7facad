#pragma once

#include "sign/local_expansion.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// Winding numbers of triangles in a ball that their border does not meet, though the triangles
/// may: a quadratic function, which passes through the triangles as if they were not there, and the
/// steps at the triangles between the centre and a point.
class Continuation
{
public:
  static constexpr int kPoints = 64;
  using Values = std::array<double, kPoints>;
  struct Points
  {
    Values x;
    Values y;
    Values z;
  };
  /// The nearest integers where the error leaves no doubt.
  struct Integers
  {
    Values values;
    Values certain; ///< 1 or 0
  };

  /// @param smooth quadratic function with the value at the centre.
  explicit Continuation(const LocalExpansion& smooth);

  /// Adds the step at a triangle, which is part of the value at the centre already.
  /// @return false if the centre is in the triangle's plane up to rounding: no continuation then.
  bool addStep(const std::array<glm::dvec3, 3>& corners, int weight);

  /// Rounds the values at points of the ball.
  /// @param rounding error of a value.
  void round(const Points& points, double rounding, Integers& result) const;

  /// Steps at the segment from the centre to a point.
  struct Step
  {
    /// A point is behind the triangle as seen from the centre where the products of its offset and
    /// these, less the last number, are all above 1, and not so where one is below -1. In between
    /// rounding decides.
    std::array<glm::dvec3, 4> normals;
    double start;
    double change;
  };

private:
  LocalExpansion smooth_;
  std::vector<Step> steps_;
};

} // namespace medial

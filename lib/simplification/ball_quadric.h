#pragma once

#include <glm/glm.hpp>

namespace medial
{

/// The weighted sum of the squared distances between the boundary of a ball and oriented planes
/// that it should touch from behind ("spherical quadric error metric": Thiery, Guy, Boubekeur,
/// "Sphere-Meshes", 2013, section 3). A plane with outward unit normal n through p is touched by
/// the balls (c, r) with n . c + r = n . p. These form a hyperplane of R^4 with the normal (n, 1),
/// so the sum is a quadratic function of R^4. Here balls are points of R^4, as toVector() makes
/// them.
class BallQuadric
{
public:
  /// Adds the plane through `point` with the outward unit normal `normal`.
  void addPlane(const glm::dvec3& point, const glm::dvec3& normal, double weight);

  BallQuadric& operator+=(const BallQuadric& other);

  /// Sum of weighted squared distances, >= 0.
  double operator()(const glm::dvec4& ball) const;

  /// Returns the ball of radius >= 0 with the smallest sum. If the planes leave it some freedom,
  /// returns the one nearest to `reference`.
  glm::dvec4 minimiser(const glm::dvec4& reference) const;

  double weight() const { return weight_; }

  ///@{
  /// Half the derivative of the sum is times(ball) - linear().
  glm::dvec4 times(const glm::dvec4& ball) const { return matrix_ * ball; }
  const glm::dvec4& linear() const { return linear_; }
  ///@}
  /// Diagonal of the matrix of times().
  glm::dvec4 diagonal() const
  {
    return { matrix_[0][0], matrix_[1][1], matrix_[2][2], matrix_[3][3] };
  }

private:
  glm::dmat4 matrix_{ 0.0 };
  glm::dvec4 linear_{ 0.0 };
  double constant_ = 0.0;
  double weight_ = 0.0;
};

} // namespace medial

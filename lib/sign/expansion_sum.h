#pragma once

#include "sign/local_expansion.h"

#include <glm/glm.hpp>

#include <array>

namespace medial
{

/// Sums up what triangles add to an expansion, eight at once.
class ExpansionSum
{
public:
  static constexpr int kLanes = 8;

  explicit ExpansionSum(const glm::dvec3& centre);

  /// Adds the value of a triangle.
  /// @param weight how often it counts.
  void addValue(const std::array<glm::dvec3, 3>& corners, int weight);
  /// Adds an edge's part of the gradient and the Hessian of the triangles whose border it is.
  void addEdge(const glm::dvec3& from, const glm::dvec3& to, int weight);
  /// Adds the value and the derivatives of a triangle.
  void addTriangle(const std::array<glm::dvec3, 3>& corners, int weight);

  /// Adds the sum to an expansion around the same centre, but for the error.
  void addTo(LocalExpansion& expansion);

  using Values = std::array<double, kLanes>;
  /// x, y and z of vectors.
  using Vectors = std::array<Values, 3>;
  /// Solid angles as products of complex numbers, and full turns.
  struct Angles
  {
    Values real;
    Values imaginary;
    Values turns;
  };
  struct Derivatives
  {
    Vectors gradient;
    Vectors diagonal; ///< of the Hessian
    Vectors mixed;    ///< derivatives: yz, zx and xy
  };

private:
  void flushTriangles();
  void flushEdges();
  double angles() const;

  glm::dvec3 centre_;
  int triangles_ = 0; ///< that wait
  int edges_ = 0;
  bool anyAngles_ = false;
  bool anyDerivatives_ = false;
  std::array<Vectors, 3> corners_; ///< of triangles that wait, as seen from the centre
  Values senses_;                  ///< 1, or -1 to turn a triangle round
  std::array<Vectors, 2> ends_;    ///< of edges that wait
  Values weights_;
  Angles angles_;
  Derivatives derivatives_;
};

} // namespace medial

#pragma once

#include "balls/ball_union.h"
#include "balls/bounding_tree.h"
#include "measure/ball_neighbours.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Tells where parts of the surface of a union lie on parts before them, so that a place of several
/// parts counts once. Surfaces of positive area coincide where balls are equal, where cones overlap
/// on the same line with the same radii, and where touching triangles of wedges overlap. A part
/// that its neighbours hide at a place is not there. Several threads may ask at once.
class CoincidentParts
{
public:
  /// @param solid, neighbours must stay as they are.
  /// @param tolerance parts this near are in the same place; world units, > 0.
  CoincidentParts(const BallUnion& solid, const BallNeighbours& neighbours, double tolerance);

  /// Whether a touching triangle of a wedge before this one has the same place.
  /// @param place of a touching triangle of the wedge.
  /// @param normal of that triangle, of unit length.
  bool onEarlierWedge(std::size_t wedge, const glm::dvec3& place, const glm::dvec3& normal) const;
  /// Whether a cone before this one has the same place.
  /// @param ball of the family of the cone's balls, which touches the place.
  /// @param normal of the lateral surface there, of unit length.
  bool onEarlierCone(std::size_t cone, const Ball& ball, const glm::dvec3& normal) const;
  /// Whether a ball before this one shows in the same place.
  /// @param normal of unit length.
  bool onEarlierBall(std::int32_t ball, const glm::dvec3& normal) const;
  /// Whether a ball is equal to one before it.
  bool isRepeated(std::int32_t ball) const;

private:
  using Triangle = std::array<glm::dvec3, 3>;

  Triangle touchingTriangle(std::size_t wedge, const glm::dvec3& normal) const;
  bool wedgeTouches(std::size_t wedge, const glm::dvec3& place, const glm::dvec3& normal) const;
  bool coneHas(std::size_t cone, const Ball& ball, const glm::dvec3& normal) const;
  bool equal(std::int32_t a, std::int32_t b) const;
  BoundingTree treeOfWedges() const;
  BoundingTree treeOfCones() const;
  BoundingTree treeOfBalls() const;
  /// Whether some item that is less than the tolerance away from a place has a property.
  template <typename Has>
  bool any(const BoundingTree& tree, const glm::dvec3& place, const Has& has) const;

  const std::vector<Ball>& balls_;
  const BallNeighbours& neighbours_;
  double tolerance_;
  BoundingTree wedges_; ///< of touching triangles: those of wedge i are 2 i and 2 i + 1
  BoundingTree cones_;  ///< of segments between centres
  BoundingTree centres_;
};

} // namespace medial

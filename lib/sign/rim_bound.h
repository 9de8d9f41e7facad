#pragma once

#include "sign/closed_surface.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Bounds how fast the winding number of a lid changes, apart from its jump at the lid. By the law
/// of Biot and Savart a straight piece of rim of length L at distance d contributes at most
/// min(L / d^2, pi / d) / (4 pi) to the gradient.
class RimBound
{
public:
  /// @param lid triangles whose first two corners are on the rim.
  explicit RimBound(const TriangleChain& lid);

  /// Returns the bound inside a ball; infinite if the rim may meet the ball.
  double maxGradient(const glm::dvec3& centre, double radius) const;

private:
  struct Piece
  {
    glm::dvec3 from;
    glm::dvec3 to;
    double length;
    int weight; ///< how often it counts

    double distance(const glm::dvec3& point) const;
  };
  /// Pieces that follow each other, seen from far away.
  struct Group
  {
    std::size_t begin;
    std::size_t end;
    glm::dvec3 middle{ 0.0 };
    double radius = 0.0;
    double weight = 0.0;
  };

  std::vector<Piece> pieces_;
  std::vector<Group> groups_;
};

} // namespace medial

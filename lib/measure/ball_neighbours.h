#pragma once

#include "balls/ball_union.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// The cones and wedges of every ball and cone of a union, and which parts of their surfaces these
/// hide. A ball touches its own cones and wedges from inside. They cover the place in direction n
/// of ball a if another ball b of theirs reaches farther along n: n . b + r_b > n . a + r_a.
class BallNeighbours
{
public:
  explicit BallNeighbours(const BallUnion& solid);

  /// Balls of the wedges.
  const std::vector<std::array<std::int32_t, 3>>& wedges() const { return wedges_; }
  /// Balls of the cones: lines and edges of wedges, each once.
  const std::vector<std::array<std::int32_t, 2>>& cones() const { return cones_; }

  /// Whether the surface of a ball is hidden in a direction.
  /// @param normal of unit length.
  bool ballHidden(std::int32_t ball, const glm::dvec3& normal) const;
  /// Whether one neighbour hides all directions within DirectionPatches::radius() of `centre`.
  bool patchHidden(std::int32_t ball, const glm::dvec3& centre) const;
  /// Whether the surface of a cone is hidden at a normal.
  /// @param normal of the cone's lateral surface, of unit length.
  bool coneHidden(std::size_t cone, const glm::dvec3& normal) const;

private:
  /// Hides the directions n with n . towards > min, and the patches around directions n with n .
  /// towards > minOfPatch. A limit above 1 hides nothing, one below -1 everything.
  struct Cover
  {
    glm::dvec3 towards; ///< unit
    double min;
    double minOfPatch;
  };

  void collectCones(const BallUnion& solid);
  static Cover coverOf(const Ball& ball, const Ball& neighbour);

  std::vector<std::array<std::int32_t, 3>> wedges_;
  std::vector<std::array<std::int32_t, 2>> cones_;
  std::vector<std::size_t> ballOffsets_{ 0 }; ///< of the covers of a ball, one more than balls
  std::vector<Cover> ballCovers_;
  std::vector<std::size_t> coneOffsets_{ 0 }; ///< of the covers of a cone's first ball
  std::vector<Cover> coneCovers_;
};

} // namespace medial

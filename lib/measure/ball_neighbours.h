#pragma once

#include "balls/ball_union.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// What every ball and cone of a union is part of, and what of their surfaces that hides. A ball is
/// touched by its own cones and wedges: they hold the place in direction n of ball a when some
/// other ball b of theirs reaches farther along n, n . b + r_b > n . a + r_a.
class BallNeighbours
{
public:
  explicit BallNeighbours(const BallUnion& solid);

  /// Balls of the wedges.
  const std::vector<std::array<std::int32_t, 3>>& wedges() const { return wedges_; }
  /// Balls of the cones: lines and edges of wedges, each once.
  const std::vector<std::array<std::int32_t, 2>>& cones() const { return cones_; }

  /// @param normal unit.
  bool ballHidden(std::int32_t ball, const glm::dvec3& normal) const;
  /// Whether one neighbour hides all directions within DirectionPatches::radius() of `centre`.
  bool patchHidden(std::int32_t ball, const glm::dvec3& centre) const;
  /// @param normal of the cone's lateral surface, unit.
  bool coneHidden(std::size_t cone, const glm::dvec3& normal) const;

private:
  /// Hides the directions n with n . towards > min, and the patches about them with n . towards >
  /// minOfPatch. What exceeds 1 hides nothing, what is below -1 everything.
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

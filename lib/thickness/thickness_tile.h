#pragma once

#include "thickness/ball_families.h"
#include "thickness/tile_radii.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// The largest radii of inscribed balls that contain the grid points of a cube.
class ThicknessTile
{
public:
  static constexpr int kSide = kTileSide; ///< points along an axis
  static constexpr int kPoints = kTilePoints;

  /// Returns the number of a point from its place relative to the first.
  static int index(const glm::ivec3& place) { return pointInTile(place); }
  /// The inverse.
  static glm::ivec3 place(int index) { return placeInTile(index); }

  /// @param first position of the first grid point, as in the families.
  ThicknessTile(const BallFamilies& families, const glm::vec3& first);

  /// Sets the radius of a ball that contains a point. Points without a ball are not wanted.
  void set(int index, float radius) { radii_.radius[index] = radius; }
  float radius(int index) const { return radii_.radius[index]; }

  /// Raises the radii of the points of a slice that are in a ball to its own.
  /// @param centre as in the families.
  void raise(const glm::vec3& centre, float radius, int slice);
  /// Raises the radii to those of the largest balls of the families.
  /// @param stretch balls contain a point if they do when they are larger by this factor, >= 1.
  void raise(float stretch = 1.0f);

private:
  /// An item that may raise points.
  struct ReachedItem
  {
    std::uint32_t number;
    float span;
    float length;
    float largest;    ///< radius that counts, rounded
    BlockMask blocks; ///< with these points
  };

  float reachOf(float radius) const { return radius * stretch_ + kBallMargin; }
  BlockMask raiseByBall(const BallGroup& balls, std::uint32_t lane, const ReachedBalls& reached);
  BlockMask blocksNear(const ReachedItem& reached);
  void raiseBy(std::uint32_t number, BlockMask blocks);
  void update(BlockMask changed);

  const BallFamilies& families_;
  glm::vec3 first_;
  TileRadii radii_;
  std::vector<glm::vec4> balls_; ///< of an item, with the squares of their radii
  float stretch_ = 1.0f;
  double limit_ = 0.0; ///< negative of the smallest radius of all
};

} // namespace medial

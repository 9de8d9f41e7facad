#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

// The grid points of a tile, a cube of eight along each axis, against inscribed balls. The points
// are in blocks of two along each axis, which are compared at once. All places are relative to the
// tile's first point, and all lengths are in units of the finest spacing.
namespace medial
{

constexpr int kTileSide = 8;  ///< points along an axis
constexpr int kBlockSide = 2; ///< points along an axis
constexpr int kBlocksAlong = kTileSide / kBlockSide;
constexpr int kBlockPoints = kBlockSide * kBlockSide * kBlockSide;
constexpr int kTileBlocks = kBlocksAlong * kBlocksAlong * kBlocksAlong;
constexpr int kTilePoints = kTileBlocks * kBlockPoints;

using BlockMask = std::uint64_t; ///< bit 16 k + 4 j + i for the block (i, j, k)

/// Returns the number of a point among those of a tile: block after block, x fastest in both.
inline int pointInTile(const glm::ivec3& place)
{
  const glm::ivec3 block = place / kBlockSide;
  const glm::ivec3 within = place % kBlockSide;
  return ((block.z * kBlocksAlong + block.y) * kBlocksAlong + block.x) * kBlockPoints +
    (within.z * kBlockSide + within.y) * kBlockSide + within.x;
}

/// The inverse.
inline glm::ivec3 placeInTile(int point)
{
  const auto placeOf = [](int number, int side)
  { return glm::ivec3(number, number / side, number / (side * side)) % side; };
  return kBlockSide * placeOf(point / kBlockPoints, kBlocksAlong) +
    placeOf(point % kBlockPoints, kBlockSide);
}

/// Points this far outside of a ball count as inside: what rounding may add.
constexpr float kBallMargin = 1e-3f;

constexpr float kRadiusStep = 1.0f / 512.0f;

/// Rounds a radius to multiples of kRadiusStep. Then the largest of many radii does not depend on
/// which of nearly equal ones were left out.
float roundedRadius(float radius);

/// Bounds of balls: centres in a box, and radii of at most `reach`.
struct BallBounds
{
  glm::vec3 low;
  glm::vec3 high;
  float reach;   ///< of the balls, stretched
  float largest; ///< of the radii that count, rounded
};

constexpr int kGroupBalls = 8;

/// Eight balls, and for each the families of balls that all have it at an end. Where there are
/// fewer, the rest is 0.
struct BallGroup
{
  alignas(32) float x[kGroupBalls]; ///< of the centres
  alignas(32) float y[kGroupBalls];
  alignas(32) float z[kGroupBalls];
  alignas(32) float radius[kGroupBalls];
  alignas(32) float middleX[kGroupBalls]; ///< centres of balls around the families
  alignas(32) float middleY[kGroupBalls];
  alignas(32) float middleZ[kGroupBalls];
  alignas(32) float span[kGroupBalls];    ///< radii of these
  alignas(32) float length[kGroupBalls];  ///< longest edge of the families
  alignas(32) float largest[kGroupBalls]; ///< radius of the families
};

/// Those of eight balls whose families might raise points.
struct ReachedBalls
{
  unsigned lanes = 0;                     ///< a bit for each
  alignas(32) float radius[kGroupBalls];  ///< that count, rounded
  alignas(32) float largest[kGroupBalls]; ///< of the families, rounded
};

/// A ball, and families of balls that all have it at an end.
struct CommonBall
{
  glm::vec3 centre;
  float reach;      ///< of the ball, stretched
  glm::vec3 middle; ///< of a ball around the families
  float span;       ///< its radius, stretched
  float radius;     ///< that counts, rounded
  float largest;    ///< of the families, rounded
};

/// Balls with centres a + u d and radii r + u s for u in [0, 1], s >= 0.
struct EdgeFamily
{
  glm::vec3 a;
  glm::vec3 d;
  float r;
  float s;
  float largest; ///< radius that counts, rounded

  /// @param first, second centres and radii.
  /// @param origin of the tile.
  /// @param stretch factor from the radii that count to r and s.
  EdgeFamily(const glm::vec4& first, const glm::vec4& second, const glm::vec3& origin,
    float stretch);

  static float largestOf(const glm::vec4& first, const glm::vec4& second)
  {
    return roundedRadius(std::max(first.w, second.w));
  }
};

/// Balls with centres within a triangle. At x the coordinates of the foot of x on its plane are
/// u (x - a) and v (x - a), and the radius is r + g (x - a).
struct TriangleFamily
{
  glm::vec3 a;
  glm::vec3 normal; ///< of unit length
  glm::vec3 u;
  glm::vec3 v;
  glm::vec3 g;
  glm::vec3 across; ///< perpendicular to g in the plane: of unit length, or 0 if g is
  float acrossMin;  ///< of x - a along it, for x in the triangle
  float acrossMax;
  float r;
  float largest; ///< radius that counts, rounded
  /// Whether balls within it can contain what those on its edges don't: not if it is narrow, and
  /// not if each lies in a larger one of the same triangle.
  bool counts = false;

  TriangleFamily(const glm::vec4& first, const glm::vec4& second, const glm::vec4& third,
    const glm::vec3& origin, float stretch);

  static float largestOf(const glm::vec4& first, const glm::vec4& second, const glm::vec4& third)
  {
    return roundedRadius(std::max(std::max(first.w, second.w), third.w));
  }
};

struct RaisedBlocks
{
  BlockMask changed;
  BlockMask near; ///< blocks with points that the ball's families might raise
};

/// Where the points of every tile are.
struct TilePlaces
{
  /// @param betweenPoints distances between neighbouring points.
  explicit TilePlaces(const glm::vec3& betweenPoints);

  glm::vec3 step; ///< between neighbouring points
  /// For each axis and place of a block along it: coordinates of its points.
  alignas(32) float ofBlocks[3][kBlocksAlong][kBlockPoints];
};

/// The radii of a tile's points.
struct TileRadii
{
  explicit TileRadii(const TilePlaces& placesOfPoints)
    : places(placesOfPoints)
  {
  }

  const TilePlaces& places;
  glm::vec3 low; ///< bounds of the points whose radii are wanted
  glm::vec3 high;
  alignas(32) float radius[kTilePoints];
  alignas(32) float blockMin[kTileBlocks]; ///< smallest radius in a block
  float min = 0.0f;                        ///< smallest radius of all

  /// Finds the bounds of the points whose radii are wanted: those that are not `unwanted`.
  void findBounds(float unwanted);
  /// Updates the smallest radii of some blocks, and of all.
  void updateBlocks(BlockMask blocks);
  /// Returns the smallest radius in some blocks.
  float minOf(BlockMask blocks) const;

  /// Raises the radii of the points in some blocks to the largest ball of a family that contains
  /// each.
  /// @param shrink factor from the radii of the family to those that count.
  /// @return the blocks that changed.
  BlockMask raise(const EdgeFamily& family, BlockMask blocks, float shrink);
  /// The same without the edges of the triangle.
  BlockMask raise(const TriangleFamily& family, BlockMask blocks, float shrink);
  /// Raises the radii of the points in some blocks to that of a ball.
  RaisedBlocks raise(const CommonBall& ball, BlockMask blocks);
  /// Raises the radii of the points of a slice to that of a ball. Returns the blocks that changed.
  BlockMask raiseSlice(const glm::vec3& centre, float reach, float largest, int slice);

  /// Returns the balls whose families might raise points of the tile.
  /// @param first place of the tile, relative to which balls have theirs.
  /// @param stretch factor from the radii that count to those that balls have.
  ReachedBalls ballsNear(const BallGroup& balls, const glm::vec3& first, float stretch) const;
  /// Returns the blocks with points that balls might raise.
  BlockMask blocksWithin(const BallBounds& bounds) const;
  /// Returns those of some blocks with points that a family between some balls might raise.
  /// @param balls centres and squares of their radii.
  /// @param bump by how much the power of a point, its squared distance from the centre without the
  ///   squared radius, may be less for a ball of the family than for all of these.
  /// @param largest radius of the family that counts, rounded.
  BlockMask blocksNear(const glm::vec4* balls, std::size_t count, float bump, float largest,
    BlockMask blocks) const;
  /// Returns the blocks with points whose radius is below a limit.
  BlockMask blocksBelow(float limit) const;
};

} // namespace medial

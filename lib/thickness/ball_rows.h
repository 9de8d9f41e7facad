#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

// Grid points in rows of eight, which a tile has 64 of, against inscribed balls. All places are
// relative to the tile's first point, and all lengths are in units of the finest spacing.
namespace medial
{

using RowMask = std::uint64_t; ///< bit 8 k + j for the row (j, k)

constexpr int kRowLength = 8;
constexpr int kTileRows = kRowLength * kRowLength;
constexpr int kTilePoints = kTileRows * kRowLength;

/// Where a point of a tile is among the others, x fastest.
inline glm::ivec3 placeInTile(int point)
{
  return { point % kRowLength, point / kRowLength % kRowLength, point / kTileRows };
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

/// Eight balls, and for each the families of balls that all have it at an end. Where there are
/// fewer, the rest is 0.
struct BallRow
{
  alignas(32) float x[kRowLength]; ///< of the centres
  alignas(32) float y[kRowLength];
  alignas(32) float z[kRowLength];
  alignas(32) float radius[kRowLength];
  alignas(32) float length[kRowLength]; ///< how far from the centre those of the families are
  alignas(32) float reach[kRowLength];  ///< largest radius of the families
};

/// Those of eight balls whose families might raise points.
struct ReachedBalls
{
  unsigned lanes = 0;                    ///< a bit for each
  alignas(32) float radius[kRowLength];  ///< that count, rounded
  alignas(32) float largest[kRowLength]; ///< of the families, rounded
};

/// A ball, and families of balls that all have it at an end.
struct CommonBall
{
  glm::vec3 centre;
  float reach;       ///< of the ball, stretched
  float familyReach; ///< around the centre, of the families
  float radius;      ///< that counts, rounded
  float largest;     ///< of the families, rounded
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

struct RaisedRows
{
  RowMask changed;
  RowMask near; ///< rows with points that the ball's families might raise
};

/// The radii of a tile's points.
struct TileRadii
{
  glm::vec3 step; ///< between neighbouring points
  glm::vec3 low;  ///< bounds of the points whose radii are wanted
  glm::vec3 high;
  alignas(32) float radius[kTilePoints];
  alignas(32) float rowMin[kTileRows]; ///< smallest radius in a row
  float min = 0.0f;                    ///< smallest radius of all

  /// Finds the bounds of the points whose radii are wanted: those that are not `unwanted`.
  void findBounds(float unwanted);
  /// Updates the smallest radii of some rows, and of all.
  void updateRows(RowMask rows);
  /// Returns the smallest radius in some rows.
  float minOf(RowMask rows) const;

  /// Raises the radii of the points in some rows to the largest ball of a family that contains
  /// each.
  /// @param shrink factor from the radii of the family to those that count.
  /// @return the rows that changed.
  RowMask raise(const EdgeFamily& family, RowMask rows, float shrink);
  /// The same without the edges of the triangle.
  RowMask raise(const TriangleFamily& family, RowMask rows, float shrink);
  /// Raises the radii of the points in some rows to that of a ball.
  RaisedRows raise(const CommonBall& ball, RowMask rows);

  /// Returns the balls whose families might raise points of the tile.
  /// @param first place of the tile, relative to which balls have theirs.
  /// @param stretch factor from the radii that count to those that balls have.
  ReachedBalls ballsNear(const BallRow& balls, const glm::vec3& first, float stretch) const;
  /// Returns the rows with points that balls might raise.
  RowMask rowsWithin(const BallBounds& bounds) const;
  /// Returns those of some rows with points that a family between some balls might raise.
  /// @param balls centres and squares of their radii.
  /// @param bump by how much the power of a point, its squared distance from the centre without the
  ///   squared radius, may be less for a ball of the family than for all of these.
  /// @param largest radius of the family that counts, rounded.
  RowMask rowsNear(const glm::vec4* balls, std::size_t count, float bump, float largest,
    RowMask rows) const;
  /// Returns the rows with points whose radius is below a limit.
  RowMask rowsBelow(float limit) const;
};

} // namespace medial

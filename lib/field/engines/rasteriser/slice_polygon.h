#pragma once

#include <glm/glm.hpp>

#include <array>

namespace medial
{

/// a i + b j + c, an affine function over the grid points (i, j) of a slice.
struct Affine
{
  float a;
  float b;
  float c;

  float operator()(const glm::vec2& p) const { return a * p.x + b * p.y + c; }
};

/// A convex polygon on a slice, in grid points from some corner of it.
class SlicePolygon
{
public:
  /// The rectangle from (0,0) to `last`, half a grid point wider on every side.
  explicit SlicePolygon(const glm::vec2& last);

  int size() const { return size_; }
  bool empty() const { return size_ < 3; }
  /// Corner i, counted round and round.
  const glm::vec2& corner(int i) const { return corners_[i % size_]; }

  /// Keeps the part where `side` <= `limit`. A polygon with too many corners is left as it is,
  /// which is conservative.
  void clip(const Affine& side, float limit);

  /// Moves corners to the grid on which rasterisers place them, so that what is evaluated there is
  /// interpolated without loss, and joins those that become one.
  void snap();

  /// The corner from which to draw a fan of triangles: one that makes no needles, since the
  /// interpolation over needles is imprecise.
  int fanStart() const;

  /// Whether the bounding box holds a grid point; most that do not draw nothing.
  bool coversGridPoint() const;

  /// In grid points.
  double area() const;

private:
  static constexpr int kMaxCorners = 32;

  float minFanHeight(int start) const;

  std::array<glm::vec2, kMaxCorners> corners_;
  int size_ = 0;
};

} // namespace medial

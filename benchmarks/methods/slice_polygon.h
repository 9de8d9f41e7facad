#pragma once

#include <glm/glm.hpp>

#include <array>

namespace medial::benchmark
{

/// The affine function a i + b j + c over the grid points (i, j) of a slice.
struct Affine
{
  float a;
  float b;
  float c;

  float operator()(const glm::vec2& p) const { return a * p.x + b * p.y + c; }
};

/// A convex polygon on a slice. Coordinates are grid points, counted from some corner.
class SlicePolygon
{
public:
  /// Makes the rectangle from (0,0) to `last`, wider by half a grid point on every side.
  explicit SlicePolygon(const glm::vec2& last);

  int size() const { return size_; }
  bool empty() const { return size_ < 3; }
  /// Corner i; indices wrap around.
  const glm::vec2& corner(int i) const { return corners_[i % size_]; }

  /// Keeps the part where `side` <= `limit`. A polygon with too many corners stays as it is; this
  /// is conservative.
  void clip(const Affine& side, float limit);

  /// Moves corners to the subpixel grid on which rasterisers place them, so that values at corners
  /// are interpolated without loss. Corners that become equal are joined.
  void snap();

  /// The corner where a fan of triangles should start to have no needles, since interpolation over
  /// needles is imprecise.
  int fanStart() const;

  /// Whether the bounding box contains a grid point; most polygons that draw nothing fail this
  /// test.
  bool coversGridPoint() const;

  /// Area in grid points.
  double area() const;

private:
  static constexpr int kMaxCorners = 32;

  float minFanHeight(int start) const;

  std::array<glm::vec2, kMaxCorners> corners_;
  int size_ = 0;
};

} // namespace medial::benchmark

#pragma once

#include "thickness/ball_families.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace medial
{

/// Rounds a radius, in units of the finest spacing, to 1/512. Then the largest of many radii does
/// not depend on which of nearly equal ones were left out.
float roundedRadius(float radius);

/// The largest radii of inscribed balls that contain the grid points of a cube.
class ThicknessTile
{
public:
  static constexpr int kRow = 8;
  static constexpr int kRows = kRow * kRow;
  static constexpr int kPoints = kRows * kRow;

  static int index(int i, int j, int k) { return (k * kRow + j) * kRow + i; }

  /// @param first position of the first grid point, as in the families.
  ThicknessTile(const BallFamilies& families, const glm::vec3& first);

  /// Sets the radius of a ball that contains a point. Points without a ball are not wanted.
  void set(int index, float radius) { radius_[index] = radius; }
  float radius(int index) const { return radius_[index]; }

  /// Raises the radii to those of the largest balls of the families.
  /// @param stretch balls contain a point if they do when they are larger by this factor, >= 1.
  void raise(float stretch = 1.0f);

private:
  using RowMask = std::uint64_t; ///< bit 8 k + j for the row (j, k)

  void updateRow(int row);
  void updateLimit();
  /// The rows with points that balls with centres in a box and this radius could raise.
  RowMask rowsReached(const ItemBounds& bounds) const;
  void raiseBy(const BallFamilies::Item& item, RowMask rows);

  const BallFamilies& families_;
  glm::vec3 first_;
  alignas(32) float radius_[kPoints];
  alignas(32) float rowMin_[kRows]; ///< smallest radius in a row
  float stretch_ = 1.0f;
  double limit_ = 0.0; ///< negative of the smallest radius of all
};

} // namespace medial

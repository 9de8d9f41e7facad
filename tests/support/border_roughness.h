#pragma once

#include "medial/medial_axis.h"

namespace medial::test
{

/// Borders of the sheets of an axis: rims of 20 voxels or more.
struct Borders
{
  double length = 0.0;   ///< world units
  double averaged = 0.0; ///< the length of their moving average over 5 voxels

  /// 1 for straight lines and, nearly, for wide curves; more where borders are jagged.
  double roughness() const { return averaged > 0.0 ? length / averaged : 1.0; }
};

/// Measures the borders of an axis.
/// @param voxel the grid step.
Borders bordersOf(const MedialAxis& axis, double voxel);

} // namespace medial::test

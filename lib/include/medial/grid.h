#pragma once

#include "medial/export.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace medial
{

/// A point or vector in world units.
using Point3 = std::array<double, 3>;

/// An axis-aligned box; min <= max in every component unless it is empty.
struct MEDIAL_EXPORT Bounds
{
  Point3 min{}; ///< smallest coordinates, world units
  Point3 max{}; ///< largest coordinates, world units

  double diagonal() const; ///< length of the diagonal, world units
  /// Whether it contains no point.
  bool empty() const { return max[0] < min[0] || max[1] < min[1] || max[2] < min[2]; }
};

/// The bounds of no point: joined with others, they change nothing.
constexpr Bounds kEmptyBounds{ { HUGE_VAL, HUGE_VAL, HUGE_VAL },
  { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };

/// Returns the smallest bounds that contain both.
MEDIAL_EXPORT Bounds joined(const Bounds& a, const Bounds& b);

/// Returns the bounds of points; kEmptyBounds if there are none.
MEDIAL_EXPORT Bounds boundsOf(const std::vector<Point3>& points);

/// A box of grid points that includes both ends, like the extents of VTK.
struct MEDIAL_EXPORT Extent
{
  std::array<int, 3> min{};             ///< first point along x, y, z
  std::array<int, 3> max{ -1, -1, -1 }; ///< last point; below min if the extent is empty

  /// Whether it contains no point.
  bool empty() const { return max[0] < min[0] || max[1] < min[1] || max[2] < min[2]; }
  /// Number of points along axis 0, 1 or 2.
  int size(int axis) const { return max[axis] - min[axis] + 1; }
  std::int64_t pointCount() const;          ///< number of points; 0 if it is empty
  bool contains(const Extent& other) const; ///< whether it contains all points of `other`
};

/// A regular grid: point (i,j,k) lies at origin + (i,j,k) * spacing.
struct MEDIAL_EXPORT Grid
{
  Point3 origin{};                          ///< position of point (0,0,0), world units
  Point3 spacing{ 1.0, 1.0, 1.0 };          ///< world units, each > 0
  std::array<int, 3> dimensions{ 1, 1, 1 }; ///< points along x, y, z

  Extent wholeExtent() const;              ///< all points, (0,0,0) first
  std::int64_t pointCount() const;         ///< product of the dimensions
  Point3 point(int i, int j, int k) const; ///< position of a point, world units
};

/// Smallest number of grid points along one axis.
constexpr int kMinDimension = 1;
/// Largest number of grid points along one axis.
constexpr int kMaxDimension = 8192;

/// Smallest number of grid points along the longest axis; the largest is kMaxDimension.
constexpr int kMinResolution = 2;
/// Default number of grid points along the longest axis.
constexpr int kDefaultResolution = 256;
/// Largest margin around the mesh as a fraction of the diagonal of its bounds; the smallest is 0.
constexpr double kMaxPadding = 10.0;
/// Default margin around the mesh as a fraction of the diagonal of its bounds.
constexpr double kDefaultPadding = 0.05;

/// Makes an isotropic grid with `resolution` points along the longest axis of the padded bounds.
///
/// @param bounds of the mesh, in world units.
/// @param resolution in [kMinResolution, kMaxDimension].
/// @param padding margin on every side as a fraction of the diagonal of `bounds`, in
///   [0, kMaxPadding]. The bounds of a single point get a margin of one world unit.
/// @throws Error InvalidInput if an argument is outside its range.
MEDIAL_EXPORT Grid makeGrid(const Bounds& bounds, int resolution = kDefaultResolution,
  double padding = kDefaultPadding);

/// Makes a grid of the given spacing (world units, each > 0) that covers the padded bounds and is
/// centred on them. `bounds` and `padding` are as for makeGrid().
/// @throws Error InvalidInput if a spacing is not positive and finite, or if the grid would need
///   more than kMaxDimension points along an axis.
MEDIAL_EXPORT Grid makeGridWithSpacing(const Bounds& bounds, const Point3& spacing,
  double padding = kDefaultPadding);

/// Checks that a grid has a finite origin, positive finite spacing, and dimensions in
/// [kMinDimension, kMaxDimension].
/// @throws Error InvalidInput naming the value and its range.
MEDIAL_EXPORT void validateGrid(const Grid& grid);

} // namespace medial

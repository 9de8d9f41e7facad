#include "medial/grid.h"

#include "base/range_check.h"
#include "medial/error.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace medial
{

namespace
{

/// Rounding may lengthen an axis by this share of a spacing without adding a point.
constexpr double kCountTolerance = 1e-9;
constexpr char kAxisNames[] = "xyz";

[[noreturn]] void throwBadSpacing(double spacing, int axis)
{
  throwOutside(std::string("spacing along ") + kAxisNames[axis], spacing, "(0, infinity)");
}

bool isPositiveFinite(double value)
{
  return std::isfinite(value) && value > 0.0;
}

void checkBounds(const Bounds& bounds)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(bounds.min[axis] <= bounds.max[axis]) || !std::isfinite(bounds.min[axis]) ||
      !std::isfinite(bounds.max[axis]) || !std::isfinite(bounds.diagonal()))
    {
      std::ostringstream message;
      message << "bounds [" << bounds.min[axis] << ", " << bounds.max[axis] << "] along "
              << kAxisNames[axis] << " are not finite with min <= max";
      throw Error(ErrorCode::InvalidInput, message.str());
    }
  }
}

void checkPadding(double padding)
{
  if (!(padding >= 0.0 && padding <= kMaxPadding))
  {
    throwOutside("padding", padding, closedRange(0.0, kMaxPadding));
  }
}

/// Returns the lengths of the padded bounds. The bounds themselves are not widened, since far from
/// the origin that would round each axis differently.
Point3 paddedLengths(const Bounds& bounds, double padding)
{
  const double diagonal = bounds.diagonal();
  const double margin = diagonal > 0.0 ? padding * diagonal : 1.0;
  Point3 lengths;
  for (int axis = 0; axis < 3; ++axis)
  {
    lengths[axis] = bounds.max[axis] - bounds.min[axis] + 2.0 * margin;
  }
  return lengths;
}

/// Returns the number of points that cover a length, both ends included. It is a double, since it
/// may exceed int.
double pointsToCover(double length, double spacing)
{
  return std::max(0.0, std::ceil(length / spacing - kCountTolerance)) + 1.0;
}

void centreOn(const Bounds& bounds, Grid& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double centre = 0.5 * bounds.min[axis] + 0.5 * bounds.max[axis];
    grid.origin[axis] = centre - 0.5 * grid.spacing[axis] * (grid.dimensions[axis] - 1);
  }
}

} // namespace

double Bounds::diagonal() const
{
  return std::hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
}

Bounds joined(const Bounds& a, const Bounds& b)
{
  Bounds result;
  for (int axis = 0; axis < 3; ++axis)
  {
    result.min[axis] = std::min(a.min[axis], b.min[axis]);
    result.max[axis] = std::max(a.max[axis], b.max[axis]);
  }
  return result;
}

Bounds boundsOf(const std::vector<Point3>& points)
{
  Bounds result = kEmptyBounds;
  for (const Point3& point : points)
  {
    result = joined(result, { point, point });
  }
  return result;
}

std::int64_t Extent::pointCount() const
{
  return empty() ? 0 : static_cast<std::int64_t>(size(0)) * size(1) * size(2);
}

bool Extent::contains(const Extent& other) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (other.min[axis] < min[axis] || other.max[axis] > max[axis])
    {
      return other.empty();
    }
  }
  return true;
}

Extent Grid::wholeExtent() const
{
  return { { 0, 0, 0 }, { dimensions[0] - 1, dimensions[1] - 1, dimensions[2] - 1 } };
}

std::int64_t Grid::pointCount() const
{
  return wholeExtent().pointCount();
}

Point3 Grid::point(int i, int j, int k) const
{
  return { origin[0] + i * spacing[0], origin[1] + j * spacing[1], origin[2] + k * spacing[2] };
}

Grid makeGrid(const Bounds& bounds, int resolution, double padding)
{
  checkBounds(bounds);
  checkPadding(padding);
  if (resolution < kMinResolution || resolution > kMaxDimension)
  {
    throwOutside("resolution", resolution, closedRange(kMinResolution, kMaxDimension));
  }
  const Point3 lengths = paddedLengths(bounds, padding);
  const double spacing = *std::max_element(lengths.begin(), lengths.end()) / (resolution - 1);
  Grid grid;
  grid.spacing = { spacing, spacing, spacing };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!isPositiveFinite(spacing))
    {
      throwBadSpacing(spacing, axis);
    }
    const double count = pointsToCover(lengths[axis], spacing);
    grid.dimensions[axis] = static_cast<int>(std::min<double>(count, resolution));
  }
  centreOn(bounds, grid);
  return grid;
}

Grid makeGridWithSpacing(const Bounds& bounds, const Point3& spacing, double padding)
{
  checkBounds(bounds);
  checkPadding(padding);
  const Point3 lengths = paddedLengths(bounds, padding);
  Grid grid;
  grid.spacing = spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!isPositiveFinite(spacing[axis]))
    {
      throwBadSpacing(spacing[axis], axis);
    }
    const double count = pointsToCover(lengths[axis], spacing[axis]);
    if (!(count <= kMaxDimension))
    {
      std::ostringstream message;
      message << "spacing " << spacing[axis] << " along " << kAxisNames[axis] << " needs " << count
              << " points, more than " << kMaxDimension;
      throw Error(ErrorCode::InvalidInput, message.str());
    }
    grid.dimensions[axis] = static_cast<int>(count);
  }
  centreOn(bounds, grid);
  return grid;
}

void validateGrid(const Grid& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(grid.origin[axis]))
    {
      std::ostringstream message;
      message << "origin " << grid.origin[axis] << " along " << kAxisNames[axis]
              << " is not finite";
      throw Error(ErrorCode::InvalidInput, message.str());
    }
    if (!isPositiveFinite(grid.spacing[axis]))
    {
      throwBadSpacing(grid.spacing[axis], axis);
    }
    const int dimension = grid.dimensions[axis];
    if (dimension < kMinDimension || dimension > kMaxDimension)
    {
      throwOutside(std::string("dimension along ") + kAxisNames[axis], dimension,
        closedRange(kMinDimension, kMaxDimension));
    }
  }
}

} // namespace medial

#include "thickness/slab_thickness.h"

#include "thickness/ball_ascent.h"
#include "thickness/thickness_tile.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace medial
{
namespace
{

constexpr int kSide = ThicknessTile::kSide;
/// Gaps between balls are looked at from narrow ones on, so that points get the ball next to them
/// and not the largest one around: as shares of how far other balls may stick out.
constexpr float kFirstGap = 1.0f / 32.0f;
constexpr float kGapFactor = 2.0f;
/// Smaller balls may be those of tips that are too thin for the axis, if they hold points this near
/// to the surface, voxels.
constexpr float kSmall = 0.75f;
constexpr float kNear = 0.5f;
/// Points this near to the surface may be in larger balls whose angles are too small for the
/// families, voxels.
constexpr float kNearest = 1.0f / 16.0f;

/// Calls visit(point of the tile, point of the slab) for the points of a tile.
/// @param tile part of a cube of kSide points, which begins at a multiple of kSide on every axis.
template <typename Visit>
void forPoints(const Extent& tile, const Extent& slab, const Visit& visit)
{
  for (int k = tile.min[2]; k <= tile.max[2]; ++k)
  {
    for (int j = tile.min[1]; j <= tile.max[1]; ++j)
    {
      const std::int64_t row =
        (static_cast<std::int64_t>(k - slab.min[2]) * slab.size(1) + (j - slab.min[1])) *
          slab.size(0) -
        slab.min[0];
      for (int i = tile.min[0]; i <= tile.max[0]; ++i)
      {
        visit(ThicknessTile::index(glm::ivec3(i, j, k) % kSide), row + i);
      }
    }
  }
}

/// Raises the radii of the points that are only in the balls around themselves, and in others if
/// these are larger by a factor. Returns the number of those that remain.
/// @param missing whether a point is one of them.
int raiseGaps(const BallFamilies& families, const glm::vec3& first, const float* own, float stretch,
  bool* missing, ThicknessTile& radii)
{
  ThicknessTile gaps(families, first);
  for (int point = 0; point < ThicknessTile::kPoints; ++point)
  {
    if (missing[point])
    {
      gaps.set(point, own[point]);
    }
  }
  gaps.raise(stretch);
  int left = 0;
  for (int point = 0; point < ThicknessTile::kPoints; ++point)
  {
    const float radius = gaps.radius(point);
    // Elsewhere a point in no larger ball is the centre of the largest one.
    if (missing[point] && radius > own[point] && own[point] <= 2.0f * (stretch - 1.0f) * radius)
    {
      radii.set(point, radius);
      missing[point] = false;
    }
    left += missing[point] ? 1 : 0;
  }
  return left;
}

/// Balls with smaller separation angles than those of the families stick out of them. Points there
/// are in none, near the surface, and get the ball that they are next to.
/// @param own radii of the balls around the points; 0 where none is wanted.
void raiseGaps(const BallFamilies& families, const glm::vec3& first, const float* own,
  ThicknessTile& radii)
{
  bool missing[ThicknessTile::kPoints];
  bool any = false;
  for (int point = 0; point < ThicknessTile::kPoints; ++point)
  {
    missing[point] = own[point] > 0.0f && radii.radius(point) == own[point];
    any = any || missing[point];
  }
  for (float share = kFirstGap; any && share <= 1.0f; share *= kGapFactor)
  {
    const float stretch = 1.0f + share * (families.stretch() - 1.0f);
    any = raiseGaps(families, first, own, stretch, missing, radii) > 0;
  }
}

/// Raises the radii of points where the families lack balls: in tips, beyond the last grid edge
/// that the axis crosses, and right at the surface. What is found for one point helps with others
/// of the same slice alone: slabs may cut between slices.
/// @param corner first grid point of the tile.
/// @param own radii of the balls around the points; 0 where none is wanted.
void raiseNearSurface(const SiteQuery& query, const GridFrame& frame, const glm::ivec3& corner,
  const float* own, ThicknessTile& radii)
{
  const auto raiseAt = [&](const glm::ivec3& place, BallAscent& ascent)
  {
    const int point = ThicknessTile::index(place);
    const float radius = radii.radius(point);
    const bool inTip = own[point] <= kNear && radius <= std::max(kSmall, own[point]);
    if (!(own[point] > 0.0f) || (!inTip && own[point] > kNearest))
    {
      return;
    }
    const auto ball = ascent.largerBallAround(frame.sample(glm::dvec3(corner + place)),
      static_cast<double>(radius));
    if (ball)
    {
      const auto larger = static_cast<float>(ball->radius);
      radii.raise(glm::vec3(ball->centre - frame.first), larger, place.z);
      radii.set(point, std::max(radii.radius(point), roundedRadius(larger)));
    }
  };
  for (int k = 0; k < kSide; ++k)
  {
    BallAscent ascent(query, frame);
    for (int j = 0; j < kSide; ++j)
    {
      for (int i = 0; i < kSide; ++i)
      {
        raiseAt({ i, j, k }, ascent);
      }
    }
  }
}

} // namespace

void SlabThickness::Sums::add(float value, double binsPerUnit)
{
  min = points == 0 ? value : std::min(min, value);
  max = std::max(max, value);
  ++points;
  const auto number = static_cast<double>(value);
  sum += number;
  squares += number * number;
  const auto last = static_cast<std::ptrdiff_t>(histogram.size()) - 1;
  ++histogram[std::min(static_cast<std::ptrdiff_t>(number * binsPerUnit), last)];
}

void SlabThickness::Sums::add(const Sums& other)
{
  if (other.points > 0)
  {
    min = points == 0 ? other.min : std::min(min, other.min);
    max = std::max(max, other.max);
    points += other.points;
    sum += other.sum;
    squares += other.squares;
  }
  for (std::size_t bin = 0; bin < histogram.size(); ++bin)
  {
    histogram[bin] += other.histogram[bin];
  }
}

SlabThickness::SlabThickness(const Grid& grid, const SideBalls& interior, const SideBalls& exterior,
  int bins)
  : frame_(grid)
  , interior_(interior)
  , exterior_(exterior)
  , bins_(bins)
{
  sums_.interior.histogram.resize(bins);
  sums_.exterior.histogram.resize(bins);
}

void SlabThickness::replace(const Extent& slab, const SiteQuery& query, float* values,
  const Checkpoint& checkpoint)
{
  const auto tilesAlong = [&](int axis)
  { return slab.max[axis] / kSide - slab.min[axis] / kSide + 1; };
  const int across = tilesAlong(0);
  const int rows = tilesAlong(1);
  tbb::parallel_for(0, across * rows * tilesAlong(2),
    [&](int number)
    {
      checkpoint();
      const std::array<int, 3> place{ number % across, number / across % rows,
        number / across / rows };
      Extent tile;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int first = (slab.min[axis] / kSide + place[axis]) * kSide;
        tile.min[axis] = std::max(first, slab.min[axis]);
        tile.max[axis] = std::min(first + kSide - 1, slab.max[axis]);
      }
      this->replaceTile(tile, slab, query, values);
    });
  const std::int64_t slice = static_cast<std::int64_t>(slab.size(0)) * slab.size(1);
  std::vector<SliceSums> sums(slab.size(2));
  tbb::parallel_for(0, slab.size(2),
    [&](int k) { sums[k] = this->sumsOf(values + k * slice, slice); });
  for (const SliceSums& part : sums)
  {
    sums_.interior.add(part.interior);
    sums_.exterior.add(part.exterior);
  }
}

void SlabThickness::replaceTile(const Extent& tile, const Extent& slab, const SiteQuery& query,
  float* values) const
{
  float distances[ThicknessTile::kPoints];
  forPoints(tile, slab,
    [&](int point, std::int64_t place)
    {
      distances[point] = values[place];
      values[place] = 0.0f;
    });
  if (interior_.families != nullptr)
  {
    this->replaceSide(tile, slab, query, interior_, -1.0f, distances, values);
  }
  if (exterior_.families != nullptr)
  {
    this->replaceSide(tile, slab, query, exterior_, 1.0f, distances, values);
  }
}

/// @param sign of the distances on this side.
void SlabThickness::replaceSide(const Extent& tile, const Extent& slab, const SiteQuery& query,
  const SideBalls& side, float sign, const float* distances, float* values) const
{
  const BallFamilies& families = *side.families;
  const glm::ivec3 corner =
    glm::ivec3(tile.min[0] / kSide, tile.min[1] / kSide, tile.min[2] / kSide) * kSide;
  const glm::vec3 first = glm::vec3(corner) * families.step();
  ThicknessTile radii(families, first);
  const auto perUnit = static_cast<float>(1.0 / families.unit());
  float own[ThicknessTile::kPoints] = {};
  bool any = false;
  forPoints(tile, slab,
    [&](int point, std::int64_t)
    {
      if (sign * distances[point] > 0.0f)
      {
        // Not 0, which is for points elsewhere.
        own[point] = std::max(roundedRadius(sign * distances[point] * perUnit), kRadiusStep);
        radii.set(point, own[point]);
        any = true;
      }
    });
  if (!any)
  {
    return;
  }
  radii.raise();
  raiseGaps(families, first, own, radii);
  raiseNearSurface(query, frame_, corner, own, radii);
  const auto diameter = static_cast<float>(2.0 * families.unit());
  forPoints(tile, slab,
    [&](int point, std::int64_t place)
    {
      if (sign * distances[point] > 0.0f)
      {
        // No ball is larger but for rounding.
        const float value = std::min(radii.radius(point) * diameter, side.end);
        values[place] = sign > 0.0f && this->bothSides() ? -value : value;
      }
    });
}

SlabThickness::SliceSums SlabThickness::sumsOf(const float* values, std::int64_t count) const
{
  SliceSums sums;
  sums.interior.histogram.resize(bins_);
  sums.exterior.histogram.resize(bins_);
  const auto binsPerUnit = [&](const SideBalls& side)
  { return side.end > 0.0f ? bins_ / static_cast<double>(side.end) : 0.0; };
  const double inside = binsPerUnit(interior_);
  const double outside = binsPerUnit(exterior_);
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (values[i] < 0.0f || (values[i] > 0.0f && interior_.families == nullptr))
    {
      sums.exterior.add(std::abs(values[i]), outside);
    }
    else if (values[i] > 0.0f)
    {
      sums.interior.add(values[i], inside);
    }
  }
  return sums;
}

std::optional<LocalThicknessSummary> SlabThickness::interior() const
{
  return this->summary(interior_, sums_.interior);
}

std::optional<LocalThicknessSummary> SlabThickness::exterior() const
{
  return this->summary(exterior_, sums_.exterior);
}

std::optional<LocalThicknessSummary> SlabThickness::summary(const SideBalls& side,
  const Sums& sums) const
{
  if (side.families == nullptr)
  {
    return std::nullopt;
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  LocalThicknessSummary summary{ sums.points, kNone, kNone, kNone, kNone, sums.histogram,
    static_cast<double>(side.end) };
  if (sums.points > 0)
  {
    const auto count = static_cast<double>(sums.points);
    summary.min = static_cast<double>(sums.min);
    summary.max = static_cast<double>(sums.max);
    summary.mean = sums.sum / count;
    summary.standardDeviation =
      std::sqrt(std::max(sums.squares / count - summary.mean * summary.mean, 0.0));
  }
  return summary;
}

} // namespace medial

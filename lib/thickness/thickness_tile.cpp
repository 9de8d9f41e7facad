#include "thickness/thickness_tile.h"

#include "base/simd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Adding and subtracting this leaves multiples of 1/512, for numbers below 8,192.
constexpr float kRounding = 1.5f * (1 << 23) / 512.0f;
/// Points this far outside of a ball, in units of the finest spacing, count as inside: what
/// rounding may add.
constexpr float kMargin = 1e-3f;
/// Triangles lower than this, in the same unit, are filled by their edges.
constexpr float kNarrow = 0.02f;
constexpr float kUnwanted = std::numeric_limits<float>::infinity();

/// A family of balls, relative to a tile: centres a + u d and radii r + u s for u in [0, 1], s >=
/// 0.
struct EdgeFamily
{
  glm::vec3 a;
  glm::vec3 d;
  float r;
  float s;

  EdgeFamily(const glm::vec4& first, const glm::vec4& second, const glm::vec3& origin,
    float stretch)
  {
    const bool inOrder = first.w <= second.w;
    const glm::vec4& low = inOrder ? first : second;
    const glm::vec4& high = inOrder ? second : first;
    a = glm::vec3(low) - origin;
    d = glm::vec3(high) - glm::vec3(low);
    r = low.w * stretch;
    s = (high.w - low.w) * stretch;
  }
};

/// A family of balls with centres within a triangle, relative to a tile. At x the coordinates of
/// the foot of x on its plane are u (x - a) and v (x - a), and the radius is r + g (x - a).
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
  float last; ///< the largest radius
  /// Whether balls within it can contain what those on its edges don't: not if it is narrow, and
  /// not if each lies in a larger one of the same triangle.
  bool counts = false;

  TriangleFamily(const glm::vec4& first, const glm::vec4& second, const glm::vec4& third,
    const glm::vec3& origin, float stretch)
  {
    const glm::vec3 d = glm::vec3(second) - glm::vec3(first);
    const glm::vec3 e = glm::vec3(third) - glm::vec3(first);
    const float dd = glm::dot(d, d);
    const float de = glm::dot(d, e);
    const float ee = glm::dot(e, e);
    const float squaredArea = dd * ee - de * de;
    const float longest = std::max(std::max(dd, ee), dd + ee - 2.0f * de);
    if (squaredArea <= kNarrow * kNarrow * longest)
    {
      return;
    }
    a = glm::vec3(first) - origin;
    normal = glm::cross(d, e) / std::sqrt(squaredArea);
    u = (ee * d - de * e) / squaredArea;
    v = (dd * e - de * d) / squaredArea;
    r = first.w * stretch;
    g = ((second.w - first.w) * u + (third.w - first.w) * v) * stretch;
    last = std::max(std::max(first.w, second.w), third.w) * stretch;
    const float slope = glm::length(g);
    counts = slope < 1.0f;
    across = slope > 0.0f ? glm::cross(normal, g) / slope : glm::vec3(0.0f);
    const auto [low, high] = std::minmax({ 0.0f, glm::dot(across, d), glm::dot(across, e) });
    acrossMin = low - kMargin;
    acrossMax = high + kMargin;
  }
};

MEDIAL_INLINE Float8 dotOfRow(Float8 x, float y, float z, const glm::vec3& v)
{
  return x * v.x + (y * v.y + z * v.z);
}

/// Raises the radii of a row of points to the largest ball of a family that contains each.
/// @param x, y, z positions, y and z those of the whole row.
/// @param shrink factor from the radii of the family to those that count.
MEDIAL_INLINE Float8 raised(Float8 radius, const EdgeFamily& family, Float8 x, float y, float z,
  float shrink)
{
  const float r = family.r + kMargin;
  const Float8 qx = x - family.a.x;
  const float qy = y - family.a.y;
  const float qz = z - family.a.z;
  const Float8 squared = qx * qx + (qy * qy + qz * qz);
  // The ball at u contains the point where a u^2 - 2 b u + c <= 0.
  const float a = glm::dot(family.d, family.d) - family.s * family.s;
  const Float8 b = qx * family.d.x + (qy * family.d.y + qz * family.d.z + r * family.s);
  const Float8 c = squared - r * r;
  const Float8 discriminant = b * b - a * c;
  const Float8 u = (b + squareRoot(max(discriminant, Float8{}))) / a;
  const Float8 last = splat((family.r + family.s) * shrink);
  const Int8 within = (discriminant >= 0.0f) & (u >= 0.0f) & (u <= 1.0f);
  const Float8 inner = within ? (family.r + u * family.s) * shrink : Float8{};
  const Float8 largest = (a - 2.0f * b + c <= 0.0f) ? last : inner;
  return max(radius, (largest + kRounding) - kRounding);
}

/// The same for the balls within a triangle; those on its edges have families of their own.
MEDIAL_INLINE Float8 raised(Float8 radius, const TriangleFamily& family, Float8 x, float y, float z,
  float shrink)
{
  const Float8 qx = x - family.a.x;
  const float qy = y - family.a.y;
  const float qz = z - family.a.z;
  // From the foot of the point the radius grows fastest along g. The last ball on this line that
  // contains the point is the largest of the plane.
  const float squaredSlope = glm::dot(family.g, family.g);
  const float slope = std::sqrt(squaredSlope);
  const float perSlope = slope > 0.0f ? 1.0f / slope : 0.0f;
  const Float8 height = dotOfRow(qx, qy, qz, family.normal);
  const Float8 foot = dotOfRow(qx, qy, qz, family.g) + (family.r + kMargin);
  const Float8 discriminant = foot * foot - (1.0f - squaredSlope) * height * height;
  const Float8 way =
    (foot * slope + squareRoot(max(discriminant, Float8{}))) / (1.0f - squaredSlope);
  const Float8 u = dotOfRow(qx, qy, qz, family.u) + way * (glm::dot(family.u, family.g) * perSlope);
  const Float8 v = dotOfRow(qx, qy, qz, family.v) + way * (glm::dot(family.v, family.g) * perSlope);
  const Int8 within = (discriminant >= 0.0f) & (u >= 0.0f) & (v >= 0.0f) & (u + v <= 1.0f);
  const Float8 inner = min((foot - kMargin) + way * slope, splat(family.last)) * shrink;
  const Float8 largest = within ? inner : Float8{};
  return max(radius, (largest + kRounding) - kRounding);
}

/// Whether a family may raise a point of a row.
MEDIAL_INLINE bool concerns(const EdgeFamily&, Float8, float, float)
{
  return true;
}

/// The largest ball of the plane is along g from the point.
MEDIAL_INLINE bool concerns(const TriangleFamily& family, Float8 x, float y, float z)
{
  const Float8 across = dotOfRow(x - family.a.x, y - family.a.y, z - family.a.z, family.across);
  return bits((across >= family.acrossMin) & (across <= family.acrossMax)) != 0;
}

/// @return the rows that changed.
template <typename Family>
MEDIAL_INLINE std::uint64_t raisedRows(const Family& family, const glm::vec3& step,
  std::uint64_t rows, float shrink, float* radii)
{
  std::uint64_t changed = 0;
  const Float8 x = ramp() * step.x;
  for (std::uint64_t left = rows; left != 0; left &= left - 1)
  {
    const int row = __builtin_ctzll(left);
    const int slice = row / 8;
    const float y = static_cast<float>(row % 8) * step.y;
    const float z = static_cast<float>(slice) * step.z;
    if (!concerns(family, x, y, z))
    {
      continue;
    }
    float* const radius = radii + row * kLanes;
    const Float8 before = loaded(radius);
    const Float8 after = raised(before, family, x, y, z, shrink);
    if (bits(after > before) != 0)
    {
      store(after, radius);
      changed |= std::uint64_t{ 1 } << row;
    }
  }
  return changed;
}

MEDIAL_VECTORISED std::uint64_t raiseRows(const EdgeFamily& family, const glm::vec3& step,
  std::uint64_t rows, float shrink, float* radii)
{
  return raisedRows(family, step, rows, shrink, radii);
}

MEDIAL_VECTORISED std::uint64_t raiseRows(const TriangleFamily& family, const glm::vec3& step,
  std::uint64_t rows, float shrink, float* radii)
{
  return raisedRows(family, step, rows, shrink, radii);
}

/// @param low, high of the centres, relative to the tile.
MEDIAL_VECTORISED std::uint64_t rowsWithin(const glm::vec3& low, const glm::vec3& high,
  const glm::vec3& step, float radius, float stretch, const float* rowMin)
{
  const float gapX = std::max(std::max(low.x - 7.0f * step.x, -high.x), 0.0f);
  const float reach = radius * stretch + kMargin;
  const float free = reach * reach - gapX * gapX;
  if (free < 0.0f)
  {
    return 0;
  }
  const Float8 y = ramp() * step.y;
  const Float8 gapY = max(max(low.y - y, y - high.y), Float8{});
  const Float8 freeZ = free - gapY * gapY;
  std::uint64_t rows = 0;
  for (int k = 0; k < kLanes; ++k)
  {
    const float z = static_cast<float>(k) * step.z;
    const float gapZ = std::max(std::max(low.z - z, z - high.z), 0.0f);
    const Int8 reached = (loaded(rowMin + k * kLanes) < radius) & (freeZ >= gapZ * gapZ);
    rows |= static_cast<std::uint64_t>(bits(reached)) << (8 * k);
  }
  return rows;
}

} // namespace

float roundedRadius(float radius)
{
  const volatile float shifted = radius + kRounding;
  return shifted - kRounding;
}

ThicknessTile::ThicknessTile(const BallFamilies& families, const glm::vec3& first)
  : families_(families)
  , first_(first)
{
  std::fill_n(radius_, kPoints, kUnwanted);
}

void ThicknessTile::updateRow(int row)
{
  const float* const radius = radius_ + row * kRow;
  rowMin_[row] = *std::min_element(radius, radius + kRow);
}

void ThicknessTile::updateLimit()
{
  limit_ = -static_cast<double>(*std::min_element(rowMin_, rowMin_ + kRows));
}

ThicknessTile::RowMask ThicknessTile::rowsReached(const ItemBounds& bounds) const
{
  return rowsWithin(glm::vec3(bounds.min) - first_, glm::vec3(bounds.max) - first_,
    families_.step(), roundedRadius(static_cast<float>(bounds.reach)), stretch_, rowMin_);
}

void ThicknessTile::raiseBy(const BallFamilies::Item& item, RowMask rows)
{
  RowMask changed = 0;
  for (std::uint32_t e = item.edgesBegin; e < item.edgesEnd; ++e)
  {
    const BallFamilies::Edge& edge = families_.edges()[e];
    const EdgeFamily family(families_.ball(edge[0]), families_.ball(edge[1]), first_, stretch_);
    changed |= raiseRows(family, families_.step(), rows, 1.0f / stretch_, radius_);
  }
  for (std::uint32_t t = item.trianglesBegin; t < item.trianglesEnd; ++t)
  {
    const BallFamilies::Triangle& triangle = families_.triangles()[t];
    const TriangleFamily family(families_.ball(triangle[0]), families_.ball(triangle[1]),
      families_.ball(triangle[2]), first_, stretch_);
    if (family.counts)
    {
      changed |= raiseRows(family, families_.step(), rows, 1.0f / stretch_, radius_);
    }
  }
  for (RowMask left = changed; left != 0; left &= left - 1)
  {
    this->updateRow(__builtin_ctzll(left));
  }
  if (changed != 0)
  {
    this->updateLimit();
  }
}

void ThicknessTile::raise(float stretch)
{
  stretch_ = stretch;
  for (int row = 0; row < kRows; ++row)
  {
    this->updateRow(row);
  }
  this->updateLimit();
  const BoundingTree& tree = families_.tree();
  const auto minimum = [&](std::uint32_t node)
  {
    const ItemBounds& bounds = tree.bounds(node);
    return this->rowsReached(bounds) != 0
      ? -static_cast<double>(roundedRadius(static_cast<float>(bounds.reach)))
      : 0.0;
  };
  tree.searchNodes(minimum, limit_,
    [&](std::uint32_t i)
    {
      const BallFamilies::Item& item = families_.items()[i];
      if (const RowMask rows = this->rowsReached(families_.boundsOf(item)))
      {
        this->raiseBy(item, rows);
      }
    });
}

} // namespace medial

#include "thickness/ball_rows.h"

#include "base/simd.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

static_assert(kRowLength == kLanes);

/// Adding and subtracting this leaves multiples of kRadiusStep, for numbers below 8,192.
constexpr float kRounding = 1.5f * (1 << 23) * kRadiusStep;
/// Triangles lower than this are filled by their edges.
constexpr float kNarrow = 0.02f;

/// A row of points; all have the same y and z.
struct Row
{
  Float8 x;
  float y;
  float z;
};

MEDIAL_INLINE Row rowOf(int number, const glm::vec3& step)
{
  const int slice = number / kRowLength;
  return { ramp() * step.x, static_cast<float>(number % kRowLength) * step.y,
    static_cast<float>(slice) * step.z };
}

MEDIAL_INLINE Float8 squaredDistances(const Row& row, const glm::vec3& from)
{
  const Float8 x = row.x - from.x;
  const float y = row.y - from.y;
  const float z = row.z - from.z;
  return x * x + (y * y + z * z);
}

MEDIAL_INLINE Float8 dotOfRow(Float8 x, float y, float z, const glm::vec3& v)
{
  return x * v.x + (y * v.y + z * v.z);
}

MEDIAL_INLINE Float8 rounded(Float8 radius)
{
  return (radius + kRounding) - kRounding;
}

MEDIAL_INLINE float smallest(Float8 values)
{
  float least = values[0];
  for (int lane = 1; lane < kLanes; ++lane)
  {
    least = std::min(least, values[lane]);
  }
  return least;
}

MEDIAL_INLINE RowMask maskOf(int row)
{
  return RowMask{ 1 } << row;
}

/// Returns the radii of a row of points, raised to the largest ball of a family that contains each.
/// @param shrink factor from the radii of the family to those that count.
MEDIAL_INLINE Float8 raised(Float8 radius, const EdgeFamily& family, const Row& row, float shrink)
{
  const float r = family.r + kBallMargin;
  const Float8 qx = row.x - family.a.x;
  const float qy = row.y - family.a.y;
  const float qz = row.z - family.a.z;
  const Float8 squared = qx * qx + (qy * qy + qz * qz);
  // The ball at u contains the point where a u^2 - 2 b u + c <= 0.
  const float a = glm::dot(family.d, family.d) - family.s * family.s;
  const Float8 b = qx * family.d.x + (qy * family.d.y + qz * family.d.z + r * family.s);
  const Float8 c = squared - r * r;
  const Float8 discriminant = b * b - a * c;
  const Int8 inLast = a - 2.0f * b + c <= 0.0f;
  if (bits((radius < family.largest) & (inLast | (discriminant >= 0.0f))) == 0)
  {
    return radius;
  }
  const Float8 u = (b + squareRoot(max(discriminant, Float8{}))) / a;
  const Int8 within = (discriminant >= 0.0f) & (u >= 0.0f) & (u <= 1.0f);
  const Float8 last = splat(family.largest);
  const Float8 inner = within ? min(rounded((family.r + u * family.s) * shrink), last) : Float8{};
  return max(radius, inLast ? last : inner);
}

/// The same for the balls within a triangle; those on its edges have families of their own.
MEDIAL_INLINE Float8 raised(Float8 radius, const TriangleFamily& family, const Row& row,
  float shrink)
{
  const Float8 qx = row.x - family.a.x;
  const float qy = row.y - family.a.y;
  const float qz = row.z - family.a.z;
  // The largest ball of the plane is along g from the point.
  const Float8 across = dotOfRow(qx, qy, qz, family.across);
  if (bits((radius < family.largest) & (across >= family.acrossMin) &
        (across <= family.acrossMax)) == 0)
  {
    return radius;
  }
  // From the foot of the point the radius grows fastest along g. The last ball on this line that
  // contains the point is the largest of the plane.
  const float squaredSlope = glm::dot(family.g, family.g);
  const float slope = std::sqrt(squaredSlope);
  const float perSlope = slope > 0.0f ? 1.0f / slope : 0.0f;
  const Float8 height = dotOfRow(qx, qy, qz, family.normal);
  const Float8 foot = dotOfRow(qx, qy, qz, family.g) + (family.r + kBallMargin);
  const Float8 discriminant = foot * foot - (1.0f - squaredSlope) * height * height;
  const Float8 way =
    (foot * slope + squareRoot(max(discriminant, Float8{}))) / (1.0f - squaredSlope);
  const Float8 u = dotOfRow(qx, qy, qz, family.u) + way * (glm::dot(family.u, family.g) * perSlope);
  const Float8 v = dotOfRow(qx, qy, qz, family.v) + way * (glm::dot(family.v, family.g) * perSlope);
  const Int8 within = (discriminant >= 0.0f) & (u >= 0.0f) & (v >= 0.0f) & (u + v <= 1.0f);
  const Float8 inner = rounded(((foot - kBallMargin) + way * slope) * shrink);
  return max(radius, within ? min(inner, splat(family.largest)) : Float8{});
}

template <typename Family>
MEDIAL_INLINE RowMask raisedRows(const Family& family, RowMask rows, float shrink, TileRadii& radii)
{
  RowMask changed = 0;
  for (RowMask left = rows; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctzll(left);
    if (radii.rowMin[number] >= family.largest)
    {
      continue;
    }
    float* const radius = radii.radius + number * kLanes;
    const Float8 before = loaded(radius);
    const Float8 after = raised(before, family, rowOf(number, radii.step), shrink);
    if (bits(after > before) != 0)
    {
      store(after, radius);
      changed |= maskOf(number);
    }
  }
  return changed;
}

} // namespace

float roundedRadius(float radius)
{
  const volatile float shifted = radius + kRounding;
  return shifted - kRounding;
}

MEDIAL_VECTORISED void TileRadii::updateRows(RowMask rows)
{
  for (RowMask left = rows; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctzll(left);
    rowMin[number] = smallest(loaded(radius + number * kLanes));
  }
  Float8 least = loaded(rowMin);
  for (int k = 1; k < kRowLength; ++k)
  {
    least = medial::min(least, loaded(rowMin + k * kLanes));
  }
  min = smallest(least);
}

void TileRadii::findBounds(float unwanted)
{
  glm::ivec3 first(kRowLength);
  glm::ivec3 last(-1);
  for (int point = 0; point < kTilePoints; ++point)
  {
    if (radius[point] != unwanted)
    {
      const glm::ivec3 place = placeInTile(point);
      first = glm::min(first, place);
      last = glm::max(last, place);
    }
  }
  low = glm::vec3(first) * step;
  high = glm::vec3(last) * step;
}

float TileRadii::minOf(RowMask rows) const
{
  float least = std::numeric_limits<float>::max();
  for (RowMask left = rows; left != 0; left &= left - 1)
  {
    least = std::min(least, rowMin[__builtin_ctzll(left)]);
  }
  return least;
}

EdgeFamily::EdgeFamily(const glm::vec4& first, const glm::vec4& second, const glm::vec3& origin,
  float stretch)
{
  const bool inOrder = first.w <= second.w;
  const glm::vec4& low = inOrder ? first : second;
  const glm::vec4& high = inOrder ? second : first;
  a = glm::vec3(low) - origin;
  d = glm::vec3(high) - glm::vec3(low);
  r = low.w * stretch;
  s = (high.w - low.w) * stretch;
  largest = largestOf(first, second);
}

TriangleFamily::TriangleFamily(const glm::vec4& first, const glm::vec4& second,
  const glm::vec4& third, const glm::vec3& origin, float stretch)
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
  largest = largestOf(first, second, third);
  const float slope = glm::length(g);
  counts = slope < 1.0f;
  across = slope > 0.0f ? glm::cross(normal, g) / slope : glm::vec3(0.0f);
  const auto [low, high] = std::minmax({ 0.0f, glm::dot(across, d), glm::dot(across, e) });
  acrossMin = low - kBallMargin;
  acrossMax = high + kBallMargin;
}

MEDIAL_VECTORISED RowMask TileRadii::raise(const EdgeFamily& family, RowMask rows, float shrink)
{
  return raisedRows(family, rows, shrink, *this);
}

MEDIAL_VECTORISED RowMask TileRadii::raise(const TriangleFamily& family, RowMask rows, float shrink)
{
  return raisedRows(family, rows, shrink, *this);
}

MEDIAL_VECTORISED RaisedRows TileRadii::raise(const CommonBall& ball, RowMask rows)
{
  RaisedRows result{ 0, 0 };
  const float squaredReach = ball.reach * ball.reach;
  const float squaredFamilyReach = ball.familyReach * ball.familyReach;
  for (RowMask left = rows; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctzll(left);
    const Float8 squared = squaredDistances(rowOf(number, step), ball.centre);
    float* const radii = radius + number * kLanes;
    const Float8 before = loaded(radii);
    const Int8 raises = (squared <= squaredReach) & (before < ball.radius);
    const Float8 after = raises ? splat(ball.radius) : before;
    if (bits(raises) != 0)
    {
      store(after, radii);
      result.changed |= maskOf(number);
    }
    if (bits((squared <= squaredFamilyReach) & (after < ball.largest)) != 0)
    {
      result.near |= maskOf(number);
    }
  }
  return result;
}

MEDIAL_VECTORISED ReachedBalls TileRadii::ballsNear(const BallRow& balls, const glm::vec3& first,
  float stretch) const
{
  const Float8 length = loaded(balls.length);
  const auto gap = [&](const float* centres, int axis)
  {
    const Float8 centre = loaded(centres) - first[axis];
    return max(max(centre - length - high[axis], low[axis] - (centre + length)), Float8{});
  };
  const Float8 x = gap(balls.x, 0);
  const Float8 y = gap(balls.y, 1);
  const Float8 z = gap(balls.z, 2);
  const Float8 reach = loaded(balls.reach);
  const Float8 stretched = reach * stretch + kBallMargin;
  const Float8 largest = rounded(reach);
  ReachedBalls reached;
  reached.lanes = static_cast<unsigned>(
    bits((x * x + (y * y + z * z) <= stretched * stretched) & (largest > min)));
  store(rounded(loaded(balls.radius)), reached.radius);
  store(largest, reached.largest);
  return reached;
}

MEDIAL_VECTORISED RowMask TileRadii::rowsWithin(const BallBounds& bounds) const
{
  const float gapX = std::max(std::max(bounds.low.x - high.x, low.x - bounds.high.x), 0.0f);
  const float free = bounds.reach * bounds.reach - gapX * gapX;
  if (free < 0.0f)
  {
    return 0;
  }
  const Float8 y = ramp() * step.y;
  const Float8 gapY = max(max(bounds.low.y - y, y - bounds.high.y), Float8{});
  const Float8 freeZ = free - gapY * gapY;
  RowMask rows = 0;
  for (int k = 0; k < kRowLength; ++k)
  {
    const float z = static_cast<float>(k) * step.z;
    const float gapZ = std::max(std::max(bounds.low.z - z, z - bounds.high.z), 0.0f);
    const Int8 reached = (loaded(rowMin + k * kLanes) < bounds.largest) & (freeZ >= gapZ * gapZ);
    rows |= static_cast<RowMask>(bits(reached)) << (kRowLength * k);
  }
  return rows;
}

MEDIAL_VECTORISED RowMask TileRadii::rowsNear(const glm::vec4* balls, std::size_t count, float bump,
  float largest, RowMask rows) const
{
  RowMask near = 0;
  for (RowMask left = rows; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctzll(left);
    const Row row = rowOf(number, step);
    Float8 power = splat(std::numeric_limits<float>::max());
    for (std::size_t ball = 0; ball < count; ++ball)
    {
      power = medial::min(power, squaredDistances(row, glm::vec3(balls[ball])) - balls[ball].w);
    }
    const Int8 isNear = (power <= bump) & (loaded(radius + number * kLanes) < largest);
    near |= bits(isNear) != 0 ? maskOf(number) : 0;
  }
  return near;
}

MEDIAL_VECTORISED RowMask TileRadii::rowsBelow(float limit) const
{
  RowMask rows = 0;
  for (int k = 0; k < kRowLength; ++k)
  {
    const Int8 below = loaded(rowMin + k * kLanes) < limit;
    rows |= static_cast<RowMask>(bits(below)) << (kRowLength * k);
  }
  return rows;
}

} // namespace medial

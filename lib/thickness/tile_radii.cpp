#include "thickness/tile_radii.h"

#include "base/simd.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

static_assert(kBlockPoints == kLanes && kGroupBalls == kLanes);

/// Adding and subtracting this leaves multiples of kRadiusStep, for numbers below 8,192.
constexpr float kRounding = 1.5f * (1 << 23) * kRadiusStep;
/// Triangles lower than this are filled by their edges.
constexpr float kNarrow = 0.02f;

/// Where the points of a block are.
struct Block
{
  Float8 x;
  Float8 y;
  Float8 z;
};

MEDIAL_INLINE Block blockOf(const TileRadii& radii, int number)
{
  return { loaded(radii.places.ofBlocks[0][number % kBlocksAlong]),
    loaded(radii.places.ofBlocks[1][number / kBlocksAlong % kBlocksAlong]),
    loaded(radii.places.ofBlocks[2][number / (kBlocksAlong * kBlocksAlong)]) };
}

MEDIAL_INLINE Float8 squaredLength(Float8 x, Float8 y, Float8 z)
{
  return x * x + (y * y + z * z);
}

MEDIAL_INLINE Float8 squaredDistances(const Block& block, const glm::vec3& from)
{
  return squaredLength(block.x - from.x, block.y - from.y, block.z - from.z);
}

MEDIAL_INLINE Float8 dot(Float8 x, Float8 y, Float8 z, const glm::vec3& v)
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

MEDIAL_INLINE BlockMask maskOf(int block)
{
  return BlockMask{ 1 } << block;
}

/// Returns the radii of a block of points, raised to the largest ball of a family that contains
/// each.
/// @param shrink factor from the radii of the family to those that count.
MEDIAL_INLINE Float8 raised(Float8 radius, const EdgeFamily& family, const Block& block,
  float shrink)
{
  const float r = family.r + kBallMargin;
  const Float8 qx = block.x - family.a.x;
  const Float8 qy = block.y - family.a.y;
  const Float8 qz = block.z - family.a.z;
  const Float8 squared = squaredLength(qx, qy, qz);
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
MEDIAL_INLINE Float8 raised(Float8 radius, const TriangleFamily& family, const Block& block,
  float shrink)
{
  const Float8 qx = block.x - family.a.x;
  const Float8 qy = block.y - family.a.y;
  const Float8 qz = block.z - family.a.z;
  // The largest ball of the plane is along g from the point.
  const Float8 across = dot(qx, qy, qz, family.across);
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
  const Float8 height = dot(qx, qy, qz, family.normal);
  const Float8 foot = dot(qx, qy, qz, family.g) + (family.r + kBallMargin);
  const Float8 discriminant = foot * foot - (1.0f - squaredSlope) * height * height;
  const Float8 way =
    (foot * slope + squareRoot(max(discriminant, Float8{}))) / (1.0f - squaredSlope);
  const Float8 u = dot(qx, qy, qz, family.u) + way * (glm::dot(family.u, family.g) * perSlope);
  const Float8 v = dot(qx, qy, qz, family.v) + way * (glm::dot(family.v, family.g) * perSlope);
  const Int8 within = (discriminant >= 0.0f) & (u >= 0.0f) & (v >= 0.0f) & (u + v <= 1.0f);
  const Float8 inner = rounded(((foot - kBallMargin) + way * slope) * shrink);
  return max(radius, within ? min(inner, splat(family.largest)) : Float8{});
}

template <typename Family>
MEDIAL_INLINE BlockMask raisedBlocks(const Family& family, BlockMask blocks, float shrink,
  TileRadii& radii)
{
  BlockMask changed = 0;
  for (BlockMask left = blocks; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctzll(left);
    if (radii.blockMin[number] >= family.largest)
    {
      continue;
    }
    float* const radius = radii.radius + number * kLanes;
    const Float8 before = loaded(radius);
    const Float8 after = raised(before, family, blockOf(radii, number), shrink);
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

MEDIAL_VECTORISED void TileRadii::updateBlocks(BlockMask blocks)
{
  for (BlockMask left = blocks; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctzll(left);
    blockMin[number] = smallest(loaded(radius + number * kLanes));
  }
  Float8 least = loaded(blockMin);
  for (int k = 1; k < kTileBlocks / kLanes; ++k)
  {
    least = medial::min(least, loaded(blockMin + k * kLanes));
  }
  min = smallest(least);
}

TilePlaces::TilePlaces(const glm::vec3& betweenPoints)
  : step(betweenPoints)
{
  for (int point = 0; point < kTilePoints; ++point)
  {
    const glm::ivec3 place = placeInTile(point);
    for (int axis = 0; axis < 3; ++axis)
    {
      ofBlocks[axis][place[axis] / kBlockSide][point % kBlockPoints] =
        static_cast<float>(place[axis]) * step[axis];
    }
  }
}

void TileRadii::findBounds(float unwanted)
{
  glm::ivec3 first(kTileSide);
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
  low = glm::vec3(first) * places.step;
  high = glm::vec3(last) * places.step;
}

float TileRadii::minOf(BlockMask blocks) const
{
  float least = std::numeric_limits<float>::max();
  for (BlockMask left = blocks; left != 0; left &= left - 1)
  {
    least = std::min(least, blockMin[__builtin_ctzll(left)]);
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

MEDIAL_VECTORISED BlockMask TileRadii::raise(const EdgeFamily& family, BlockMask blocks,
  float shrink)
{
  return raisedBlocks(family, blocks, shrink, *this);
}

MEDIAL_VECTORISED BlockMask TileRadii::raise(const TriangleFamily& family, BlockMask blocks,
  float shrink)
{
  return raisedBlocks(family, blocks, shrink, *this);
}

MEDIAL_VECTORISED RaisedBlocks TileRadii::raise(const CommonBall& ball, BlockMask blocks)
{
  RaisedBlocks result{ 0, 0 };
  const float squaredReach = ball.reach * ball.reach;
  const float squaredSpan = ball.span * ball.span;
  for (BlockMask left = blocks; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctzll(left);
    const Block block = blockOf(*this, number);
    const Float8 squared = squaredDistances(block, ball.centre);
    float* const radii = radius + number * kLanes;
    const Float8 before = loaded(radii);
    const Int8 raises = (squared <= squaredReach) & (before < ball.radius);
    const Float8 after = raises ? splat(ball.radius) : before;
    if (bits(raises) != 0)
    {
      store(after, radii);
      result.changed |= maskOf(number);
    }
    if (bits((squaredDistances(block, ball.middle) <= squaredSpan) & (after < ball.largest)) != 0)
    {
      result.near |= maskOf(number);
    }
  }
  return result;
}

BlockMask TileRadii::raiseSlice(const glm::vec3& centre, float reach, float largest, int slice)
{
  BlockMask changed = 0;
  for (int j = 0; j < kTileSide; ++j)
  {
    for (int i = 0; i < kTileSide; ++i)
    {
      const glm::ivec3 place(i, j, slice);
      const int point = pointInTile(place);
      const glm::vec3 way = glm::vec3(place) * places.step - centre;
      if (radius[point] < largest && glm::dot(way, way) <= reach * reach)
      {
        radius[point] = largest;
        changed |= maskOf(point / kBlockPoints);
      }
    }
  }
  return changed;
}

MEDIAL_VECTORISED ReachedBalls TileRadii::ballsNear(const BallGroup& balls, const glm::vec3& first,
  float stretch) const
{
  const auto gap = [&](const float* centres, int axis)
  {
    const Float8 centre = loaded(centres) - first[axis];
    return max(max(centre - high[axis], low[axis] - centre), Float8{});
  };
  const Float8 x = gap(balls.middleX, 0);
  const Float8 y = gap(balls.middleY, 1);
  const Float8 z = gap(balls.middleZ, 2);
  const Float8 span = loaded(balls.span) * stretch + kBallMargin;
  const Float8 largest = rounded(loaded(balls.largest));
  ReachedBalls reached;
  reached.lanes =
    static_cast<unsigned>(bits((x * x + (y * y + z * z) <= span * span) & (largest > min)));
  store(rounded(loaded(balls.radius)), reached.radius);
  store(largest, reached.largest);
  return reached;
}

MEDIAL_VECTORISED BlockMask TileRadii::blocksWithin(const BallBounds& bounds) const
{
  const auto gap = [&](int axis, Float8 first)
  {
    const Float8 last = first + places.step[axis];
    return max(max(bounds.low[axis] - last, first - bounds.high[axis]), Float8{});
  };
  const glm::vec3 outside = glm::max(glm::max(bounds.low - high, low - bounds.high), 0.0f);
  const float squaredReach = bounds.reach * bounds.reach;
  if (glm::dot(outside, outside) > squaredReach)
  {
    return 0;
  }
  const glm::vec3 width = static_cast<float>(kBlockSide) * places.step;
  const Float8 gapX = gap(0, Float8{ 0, 1, 2, 3, 0, 1, 2, 3 } * width.x);
  const Float8 gapY = gap(1, Float8{ 0, 0, 0, 0, 1, 1, 1, 1 } * width.y);
  const Float8 nextY = gap(1, Float8{ 2, 2, 2, 2, 3, 3, 3, 3 } * width.y);
  const Float8 gapZ = gap(2, Float8{ 0, 1, 2, 3 } * width.z);
  const Float8 free = squaredReach - gapX * gapX;
  const Float8 frees[] = { free - gapY * gapY, free - nextY * nextY };
  BlockMask blocks = 0;
  for (int k = 0; k < kTileBlocks / kLanes; ++k)
  {
    const float z = gapZ[k / 2];
    const Int8 reached = (loaded(blockMin + k * kLanes) < bounds.largest) & (frees[k % 2] >= z * z);
    blocks |= static_cast<BlockMask>(bits(reached)) << (kLanes * k);
  }
  return blocks;
}

MEDIAL_VECTORISED BlockMask TileRadii::blocksNear(const glm::vec4* balls, std::size_t count,
  float bump, float largest, BlockMask blocks) const
{
  BlockMask near = 0;
  for (BlockMask left = blocks; left != 0; left &= left - 1)
  {
    const int number = __builtin_ctzll(left);
    const Block block = blockOf(*this, number);
    Float8 power = splat(std::numeric_limits<float>::max());
    for (std::size_t ball = 0; ball < count; ++ball)
    {
      power = medial::min(power, squaredDistances(block, glm::vec3(balls[ball])) - balls[ball].w);
    }
    const Int8 isNear = (power <= bump) & (loaded(radius + number * kLanes) < largest);
    near |= bits(isNear) != 0 ? maskOf(number) : 0;
  }
  return near;
}

MEDIAL_VECTORISED BlockMask TileRadii::blocksBelow(float limit) const
{
  BlockMask blocks = 0;
  for (int k = 0; k < kTileBlocks / kLanes; ++k)
  {
    const Int8 below = loaded(blockMin + k * kLanes) < limit;
    blocks |= static_cast<BlockMask>(bits(below)) << (kLanes * k);
  }
  return blocks;
}

} // namespace medial

#include "field/engines/processor/brick_evaluator.h"

#include "culling/nearest_element.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Number of grid points along an edge of a brick, and of a cube.
constexpr int kBrickSize = 4;
constexpr int kCubeSize = 2;
static_assert(kCubeSize * kCubeSize * kCubeSize == kLanes);

/// Numbers of parts start at multiples of this for every element.
constexpr int kPartsPerElement = 8;

constexpr float kUnknown = std::numeric_limits<float>::max();

/// The corners of the unit cube, x fastest.
constexpr Float8 kCorners[3] = { { 0, 1, 0, 1, 0, 1, 0, 1 }, { 0, 0, 1, 1, 0, 0, 1, 1 },
  { 0, 0, 0, 0, 1, 1, 1, 1 } };

/// Elements of a tile in packs of eight.
int packCount(int elements)
{
  return (elements + kLanes - 1) / kLanes;
}

/// Returns which lanes of a pack hold elements, as bits.
MEDIAL_INLINE unsigned usedLanes(int elements, int pack)
{
  const int left = elements - pack * kLanes;
  return left >= kLanes ? 0xffu : (1u << left) - 1u;
}

/// Returns the radius of the ball around n points along each axis.
float radiusOf(int n, const glm::vec3& step)
{
  return 0.5f * static_cast<float>(n - 1) * glm::length(step);
}

/// The nearest site so far of the points of a cube.
struct Nearest
{
  Float8& squared;
  Int8& part; ///< its number

  MEDIAL_INLINE void offer(Float8 candidate, Int8 allowed, int number)
  {
    const Int8 nearer = (candidate < squared) & allowed;
    squared = nearer ? candidate : squared;
    part = nearer ? Int8{} + number : part;
  }
};

/// Offers the sites of an element to the points of a cube. Edges compete wherever a point projects
/// into them, and vertices everywhere, so that rounding leaves no gaps between sites.
/// @param p the points in the element's plane.
/// @param parts those to offer, as bits of SitePart.
/// @param first number of the element's first part.
/// @return number of sites.
MEDIAL_INLINE int offerParts(const SiteGroup& group, int lane, const PlanePosition& p, int parts,
  int first, Nearest nearest)
{
  const OneElement of{ lane };
  const Float8 squaredHeight = p.height * p.height;
  const Float8 lengthAB = of(group.lengths[0]);
  const Float8 fromB = p.x - lengthAB;
  const Float8 bx = of(group.fromB[0]);
  const Float8 by = of(group.fromB[1]);
  const Float8 ax = of(group.fromA[0]);
  const Float8 ay = of(group.fromA[1]);
  if ((parts & (kFacePart | kEdgePart << 1)) != 0)
  {
    const Float8 outsideBC = fromB * by - p.y * bx;
    if ((parts & kFacePart) != 0)
    {
      const Float8 outsideAC = p.y * ax - p.x * ay;
      const Float8 outside = max(max(max(-p.y, outsideBC), outsideAC), max(-p.x, fromB));
      nearest.offer(squaredHeight, outside <= 0.0f, first);
    }
    if ((parts & kEdgePart << 1) != 0)
    {
      const Float8 t = fromB * bx + p.y * by;
      nearest.offer(squaredHeight + outsideBC * outsideBC,
        (t >= 0.0f) & (t <= of(group.lengths[1])), first + 2);
    }
  }
  if ((parts & kEdgePart) != 0)
  {
    nearest.offer(squaredHeight + p.y * p.y, (p.x >= 0.0f) & (fromB <= 0.0f), first + 1);
  }
  if ((parts & kEdgePart << 2) != 0)
  {
    const Float8 t = p.x * ax + p.y * ay;
    const Float8 s = p.y * ax - p.x * ay;
    nearest.offer(squaredHeight + s * s, (t >= 0.0f) & (t <= of(group.lengths[2])), first + 3);
  }
  if ((parts & 7 * kVertexPart) != 0)
  {
    const Int8 everywhere = Int8{} - 1;
    const Float8 squared = squaredHeight + p.y * p.y;
    if ((parts & kVertexPart) != 0)
    {
      nearest.offer(squared + p.x * p.x, everywhere, first + 4);
    }
    if ((parts & kVertexPart << 1) != 0)
    {
      nearest.offer(squared + fromB * fromB, everywhere, first + 5);
    }
    if ((parts & kVertexPart << 2) != 0)
    {
      const Float8 cx = p.x - ax * of(group.lengths[2]);
      const Float8 cy = p.y - ay * of(group.lengths[2]);
      nearest.offer(squaredHeight + cx * cx + cy * cy, everywhere, first + 6);
    }
  }
  return __builtin_popcount(static_cast<unsigned>(parts));
}

/// Returns which elements of a group can be closest in a box, as bits.
MEDIAL_VECTORISED unsigned neededElements(const SiteGroup& group, const BoxReach& reach,
  float slack)
{
  const ElementPosition centre(group, group.toGroup(glm::dvec3(reach.box().centre)));
  const Int8 parts = partsNear(group, AllElements(), centre, reach.radius() + slack);
  return bits((parts != 0) & (centre.squared <= reach.squared()));
}

} // namespace

BrickEvaluator::BrickEvaluator(const GroupTree& tree, const GridFrame& frame, float slack)
  : tree_(tree)
  , frame_(frame)
  , step_(frame.step)
  , slack_(slack)
{
}

/// Returns the number of elements. They are sorted, so that the lowest wins where several are
/// equally near.
int BrickEvaluator::pack(const BoxReach& reach, const GroupList& candidates,
  Workspace& workspace) const
{
  std::vector<std::pair<int, int>>& order = workspace.order;
  order.clear();
  for (const int id : candidates.groups())
  {
    const SiteGroup& group = tree_.groups()[id];
    for (unsigned left = neededElements(group, reach, slack_); left != 0; left &= left - 1)
    {
      const int lane = __builtin_ctz(left);
      order.emplace_back(group.elements[lane], id * kLanes + lane);
    }
  }
  std::sort(order.begin(), order.end());
  const auto count = static_cast<int>(order.size());
  std::vector<SiteGroup>& packs = workspace.packs;
  packs.resize(std::max<std::size_t>(packs.size(), packCount(count)));
  workspace.near.resize(packs.size());
  workspace.elements.resize(std::max<std::size_t>(workspace.elements.size(), count));
  for (int i = 0; i < count; ++i)
  {
    const SiteGroup& group = tree_.groups()[order[i].second / kLanes];
    SiteGroup& pack = packs[i / kLanes];
    const int lane = i % kLanes;
    pack.copy(lane, group, order[i].second % kLanes);
    const glm::dvec3 shift = group.origin - glm::dvec3(reach.box().centre);
    for (int axis = 0; axis < 3; ++axis)
    {
      pack.start[axis][lane] += static_cast<float>(shift[axis]);
    }
  }
  return count;
}

/// A brick in progress.
struct BrickEvaluator::Brick
{
  Workspace& workspace;
  int packed;      ///< number of elements in the packs
  glm::vec3 first; ///< its first point, relative to the middle of the tile
  int listed = 0;  ///< number of elements near it
};

/// The nearest sites of a cube's points, x fastest: distances, and numbers of parts.
struct alignas(32) BrickEvaluator::CubeField
{
  Float8 squared = splat(kUnknown);
  Int8 part = Int8{} - 1;
};

MEDIAL_INLINE void BrickEvaluator::listElements(Brick& brick) const
{
  Workspace& workspace = brick.workspace;
  const float radius = radiusOf(kBrickSize, step_) + slack_;
  const glm::vec3 centre = brick.first + 0.5f * static_cast<float>(kBrickSize - 1) * step_;
  float nearest = kUnknown;
  for (int i = 0; i < packCount(brick.packed); ++i)
  {
    const ElementPosition position(workspace.packs[i], centre);
    Workspace::Near& near = workspace.near[i];
    near.squared = position.squared;
    near.parts = partsNear(workspace.packs[i], AllElements(), position, radius);
    for (unsigned left = usedLanes(brick.packed, i); left != 0; left &= left - 1)
    {
      nearest = std::min(nearest, near.squared[__builtin_ctz(left)]);
    }
  }
  const float reach = std::sqrt(nearest) + 2.0f * radius;
  const float squaredReach = reach * reach * kRoundedUp;
  brick.listed = 0;
  for (int i = 0; i < packCount(brick.packed); ++i)
  {
    const Workspace::Near& near = workspace.near[i];
    for (unsigned left =
           bits((near.squared <= squaredReach) & (near.parts != 0)) & usedLanes(brick.packed, i);
         left != 0; left &= left - 1)
    {
      workspace.elements[brick.listed++].index = i * kLanes + __builtin_ctz(left);
    }
  }
}

MEDIAL_INLINE Float8 BrickEvaluator::testCubes(Brick& brick) const
{
  const float radius = radiusOf(kCubeSize, step_) + slack_;
  std::array<Float8, 3> centres;
  for (int axis = 0; axis < 3; ++axis)
  {
    centres[axis] =
      (kCorners[axis] * static_cast<float>(kCubeSize) + 0.5f) * step_[axis] + brick.first[axis];
  }
  Float8 nearest = splat(kUnknown);
  for (int i = 0; i < brick.listed; ++i)
  {
    Workspace::CubeElement& element = brick.workspace.elements[i];
    const SiteGroup& pack = brick.workspace.packs[element.index / kLanes];
    const OneElement of{ element.index % kLanes };
    element.centres = PlanePosition(pack, of,
      { centres[0] - of(pack.start[0]), centres[1] - of(pack.start[1]),
        centres[2] - of(pack.start[2]) });
    const ElementPosition position(pack, of, element.centres);
    element.squared = position.squared;
    element.parts = partsNear(pack, of, position, radius);
    nearest = min(nearest, position.squared);
  }
  const Float8 reach = squareRoot(nearest) + 2.0f * radius;
  return reach * reach * kRoundedUp;
}

MEDIAL_INLINE std::int64_t BrickEvaluator::evaluateCubes(Brick& brick, Float8 reach,
  CubeField* cubes) const
{
  std::array<Float8, 3> offsets;
  for (int axis = 0; axis < 3; ++axis)
  {
    offsets[axis] = (kCorners[axis] - 0.5f) * step_[axis];
  }
  std::int64_t evaluated = 0;
  for (int i = 0; i < brick.listed; ++i)
  {
    const Workspace::CubeElement& element = brick.workspace.elements[i];
    unsigned needed = bits((element.squared <= reach) & (element.parts != 0));
    if (needed == 0)
    {
      continue;
    }
    const SiteGroup& pack = brick.workspace.packs[element.index / kLanes];
    const int lane = element.index % kLanes;
    const PlanePosition offset(pack, OneElement{ lane }, offsets);
    for (; needed != 0; needed &= needed - 1)
    {
      const int cube = __builtin_ctz(needed);
      PlanePosition points;
      points.x = offset.x + element.centres.x[cube];
      points.y = offset.y + element.centres.y[cube];
      points.height = offset.height + element.centres.height[cube];
      evaluated += offerParts(pack, lane, points, element.parts[cube],
        element.index * kPartsPerElement, { cubes[cube].squared, cubes[cube].part });
    }
  }
  return evaluated * kLanes;
}

MEDIAL_VECTORISED std::int64_t BrickEvaluator::evaluateBrick(Brick& brick, CubeField* cubes) const
{
  this->listElements(brick);
  const Float8 reach = this->testCubes(brick);
  return this->evaluateCubes(brick, reach, cubes);
}

/// Replaces the numbers of parts by sites.
MEDIAL_VECTORISED void BrickEvaluator::findSites(const Brick& brick, CubeField* cubes) const
{
  int part = -1;
  int site = -1;
  for (CubeField* cube = cubes; cube != cubes + kLanes; ++cube)
  {
    Int8 sites = Int8{} - 1;
    for (unsigned left = bits(cube->part >= 0); left != 0;)
    {
      const int next = cube->part[__builtin_ctz(left)];
      if (next != part)
      {
        part = next;
        const int element = part / kPartsPerElement;
        site = siteOf(tree_.sites(), brick.workspace.packs[element / kLanes], element % kLanes,
          part % kPartsPerElement);
      }
      const Int8 same = cube->part == part;
      sites = same ? Int8{} + site : sites;
      left &= ~bits(same);
    }
    cube->part = sites;
  }
}

/// Stores all points of a brick, also those outside the tile, which nobody reads.
void BrickEvaluator::store(const CubeField* cubes, const glm::ivec3& corner, TileField& field)
{
  for (int k = 0; k < kBrickSize; ++k)
  {
    for (int j = 0; j < kBrickSize; ++j)
    {
      for (int i = 0; i < kBrickSize; i += kCubeSize)
      {
        const CubeField& cube = cubes[i / 2 + 2 * (j / 2) + 4 * (k / 2)];
        const int point = 2 * (j % 2) + 4 * (k % 2);
        const int index = TileField::index(corner.x + i, corner.y + j, corner.z + k);
        for (int next = 0; next < kCubeSize; ++next)
        {
          field.squared[index + next] = cube.squared[point + next];
          field.site[index + next] = cube.part[point + next];
        }
      }
    }
  }
}

std::int64_t BrickEvaluator::evaluate(const Extent& tile, const BoxReach& reach,
  const GroupList& candidates, const SliceRange& slices, TileField& field,
  Workspace& workspace) const
{
  Brick brick{ workspace, this->pack(reach, candidates, workspace), {} };
  const glm::dvec3 origin =
    frame_.sample({ tile.min[0], tile.min[1], tile.min[2] }) - glm::dvec3(reach.box().centre);
  std::int64_t evaluated = 0;
  for (int k = slices.begin / kBrickSize * kBrickSize; k < slices.end; k += kBrickSize)
  {
    for (int j = 0; j < tile.size(1); j += kBrickSize)
    {
      for (int i = 0; i < tile.size(0); i += kBrickSize)
      {
        const glm::ivec3 corner(i, j, k);
        std::array<CubeField, kLanes> cubes;
        brick.first = glm::vec3(origin + glm::dvec3(corner) * frame_.step);
        evaluated += this->evaluateBrick(brick, cubes.data());
        this->findSites(brick, cubes.data());
        store(cubes.data(), corner, field);
      }
    }
  }
  return evaluated;
}

} // namespace medial

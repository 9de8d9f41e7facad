#include "culling/group_list.h"

#include "culling/nearest_element.h"

namespace medial
{
namespace
{

MEDIAL_INLINE bool isDominated(const Discs& discs, int lane, const FrameBox& box,
  const Discs::Lanes* points, int pointCount)
{
  constexpr Float8 kSigns[3] = { { -1, 1, -1, 1, -1, 1, -1, 1 }, { -1, -1, 1, 1, -1, -1, 1, 1 },
    { -1, -1, -1, -1, 1, 1, 1, 1 } };
  std::array<Float8, 3> offset;
  std::array<Float8, 3> normal;
  for (int axis = 0; axis < 3; ++axis)
  {
    offset[axis] = kSigns[axis] * box.half[axis] + (box.centre[axis] - discs.centre[axis][lane]);
    normal[axis] = splat(discs.normal[axis][lane]);
  }
  const Float8 squared =
    DiscPosition(offset, normal)
      .squaredDistance(splat(discs.radius[lane]), splat(discs.halfHeight[lane]));
  bool dominated = false;
  for (int i = 0; i < pointCount && !dominated; ++i)
  {
    dominated = all(squared > loaded(points[i].data()));
  }
  return dominated;
}

} // namespace

MEDIAL_VECTORISED void NearestElement::tryGroup(const std::vector<SiteGroup>& groups, int next,
  const glm::dvec3& x)
{
  tryElements(groups, next, x, *this);
}

BoxReach::BoxReach(const FrameBox& box, const NearestElement& nearest, float slack)
  : BoxReach(box, std::sqrt(nearest.squared) + 2.0f * (glm::length(box.half) + slack))
{
}

BoxReach::BoxReach(const FrameBox& box, float distance)
  : box_(box)
  , radius_(glm::length(box.half))
  , squared_(distance * distance * kRoundedUp)
{
}

void BoxReach::add(const glm::vec3& point)
{
  Discs::Lanes& squared = points_[pointCount_++];
  for (int i = 0; i < FrameBox::kCorners; ++i)
  {
    const glm::vec3 offset = box_.centre + box_.corner(i) - point;
    squared[i] = glm::dot(offset, offset) * kRoundedUp;
  }
}

MEDIAL_VECTORISED unsigned BoxReach::meets(const Discs& discs) const
{
  const DiscPosition centre(discs, box_.centre);
  unsigned met =
    bits((centre.squaredDistance(discs) <= squared_) & centre.meetsRegions(discs, radius_));
  for (unsigned left = pointCount_ > 0 ? met : 0; left != 0; left &= left - 1)
  {
    const int lane = __builtin_ctz(left);
    if (isDominated(discs, lane, box_, points_.data(), pointCount_))
    {
      met &= ~(1u << lane);
    }
  }
  return met;
}

void GroupList::clear()
{
  discs_.clear();
  groups_.clear();
}

void GroupList::add(int group, const Discs& discs, int lane)
{
  const int to = this->size() % kLanes;
  if (to == 0)
  {
    discs_.emplace_back();
    discs_.back().clear();
  }
  discs_.back().copy(to, discs, lane);
  groups_.push_back(group);
}

void GroupList::refine(const BoxReach& reach, GroupList& found) const
{
  found.clear();
  for (std::size_t i = 0; i < discs_.size(); ++i)
  {
    for (unsigned left = reach.meets(discs_[i]); left != 0; left &= left - 1)
    {
      const int lane = __builtin_ctz(left);
      found.add(groups_[i * kLanes + lane], discs_[i], lane);
    }
  }
}

namespace
{

/// Returns the group whose disc is nearest, or -1.
MEDIAL_VECTORISED int nearestDisc(const std::vector<Discs>& discs, const glm::vec3& x)
{
  Float8 smallest = splat(std::numeric_limits<float>::max());
  Int8 where = Int8{} - 1;
  for (std::size_t i = 0; i < discs.size(); ++i)
  {
    const Float8 squared = DiscPosition(discs[i], x).squaredDistance(discs[i]);
    const Int8 nearer = squared < smallest;
    smallest = nearer ? squared : smallest;
    where = nearer ? Int8{} + static_cast<int>(i) : where;
  }
  int first = 0;
  for (int lane = 1; lane < kLanes; ++lane)
  {
    first = smallest[lane] < smallest[first] ? lane : first;
  }
  return where[first] * kLanes + first;
}

/// Number of packs of discs that are compared before their groups are tried.
constexpr std::size_t kPacks = 64 / kLanes;

/// Returns which groups of some packs of discs may hold an element within a squared distance, as
/// bits.
MEDIAL_INLINE std::uint64_t groupsNear(const Discs* discs, std::size_t packs, const glm::vec3& x,
  float limit)
{
  std::uint64_t near = 0;
  for (std::size_t i = 0; i < packs; ++i)
  {
    const DiscPosition position(discs[i], x);
    const Int8 met =
      (position.squaredDistance(discs[i]) <= limit) & position.meetsRegions(discs[i], 0.0f);
    near |= static_cast<std::uint64_t>(bits(met)) << (i * kLanes);
  }
  return near;
}

/// The nearest elements of the groups tried so far, lane by lane: whatever is found, no branch
/// depends on it before the end.
struct NearestInLanes
{
  Float8 squared = splat(std::numeric_limits<float>::infinity());
  Int8 group = Int8{} - 1;
  Int8 element = Int8{};

  MEDIAL_INLINE void tryGroup(const SiteGroup& tried, int number, const glm::dvec3& x)
  {
    const Float8 candidate = ElementPosition(tried, tried.toGroup(x)).squared;
    const Int8 elements = loadedInts(tried.elements.data());
    const Int8 nearer = (candidate < squared) | ((candidate == squared) & (elements < element));
    squared = nearer ? candidate : squared;
    group = nearer ? Int8{} + number : group;
    element = nearer ? elements : element;
  }

  MEDIAL_INLINE void reduce(const std::vector<SiteGroup>& groups, NearestElement& nearest) const
  {
    for (int lane = 0; lane < kLanes; ++lane)
    {
      const bool lower = squared[lane] == nearest.squared && group[lane] >= 0 &&
        element[lane] < groups[nearest.group].elements[nearest.lane];
      if (squared[lane] < nearest.squared || lower)
      {
        nearest = { squared[lane], group[lane], lane, nearest.tried };
      }
    }
  }
};

MEDIAL_VECTORISED void tryDiscs(const std::vector<SiteGroup>& groups,
  const std::vector<Discs>& discs, const std::vector<int>& ids, const glm::dvec3& x,
  NearestElement& nearest)
{
  const int tried = nearest.group;
  const glm::vec3 rounded(x);
  for (std::size_t i = 0; i < discs.size(); i += kPacks)
  {
    NearestInLanes found;
    for (std::uint64_t left =
           groupsNear(&discs[i], std::min(kPacks, discs.size() - i), rounded, limitOf(nearest));
         left != 0; left &= left - 1)
    {
      const int group = ids[i * kLanes + __builtin_ctzll(left)];
      if (group != tried)
      {
        found.tryGroup(groups[group], group, x);
        ++nearest.tried;
      }
    }
    found.reduce(groups, nearest);
  }
}

} // namespace

NearestElement GroupList::nearest(const std::vector<SiteGroup>& groups, const glm::dvec3& x,
  const NearestElement& start) const
{
  NearestElement nearest = start;
  if (nearest.group < 0)
  {
    nearest.tryGroup(groups, groups_[nearestDisc(discs_, glm::vec3(x))], x);
  }
  tryDiscs(groups, discs_, groups_, x, nearest);
  return nearest;
}

} // namespace medial

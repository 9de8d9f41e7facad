#include "culling/block_query.h"

#include "base/longest_axis.h"
#include "culling/nearest_element.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Number of questions for which groups are collected from the tree at once.
constexpr std::ptrdiff_t kCollected = 256;
/// Number of questions in a block.
constexpr std::ptrdiff_t kTogether = 32;
/// From questions without a known point, one of this many is answered by a search. The others start
/// from its site.
constexpr int kBetween = 16;
/// With more groups than this near a block, a search for each question is faster.
constexpr int kManyGroups = 256;
/// With at most this many, the elements near the block are copied side by side.
constexpr int kFewGroups = 80;

int packCount(int elements)
{
  return (elements + kLanes - 1) / kLanes;
}

FrameBox boxAround(const SiteQuery::Question* const* begin, const SiteQuery::Question* const* end)
{
  glm::dvec3 low = (*begin)->x;
  glm::dvec3 high = low;
  for (; begin != end; ++begin)
  {
    low = glm::min(low, (*begin)->x);
    high = glm::max(high, (*begin)->x);
  }
  FrameBox box{ glm::vec3(0.5 * (low + high)), {} };
  const glm::dvec3 centre(box.centre);
  box.half = glm::vec3(glm::max(high - centre, centre - low)) * kRoundedUp;
  return box;
}

float sizeOf(const FrameBox& box)
{
  return box.half.x + box.half.y + box.half.z;
}

/// Orders questions so that both halves are compact. Mostly they are as they come.
void halve(SiteQuery::Question** begin, SiteQuery::Question** middle, SiteQuery::Question** end)
{
  constexpr float kCompact = 1.7f;
  const FrameBox box = boxAround(begin, end);
  if (sizeOf(boxAround(begin, middle)) + sizeOf(boxAround(middle, end)) <= kCompact * sizeOf(box))
  {
    return;
  }
  const int axis = longestAxis(glm::dvec3(box.half));
  std::nth_element(begin, middle, end,
    [axis](const SiteQuery::Question* a, const SiteQuery::Question* b)
    { return a->x[axis] < b->x[axis]; });
}

/// Returns the distance of the known point, rounded up.
float distanceOf(const SiteQuery::Question& question)
{
  constexpr float kUp = 1.0f + std::numeric_limits<float>::epsilon();
  return static_cast<float>(glm::distance(question.x, question.closest.point)) * kUp;
}

/// Finds the groups whose discs may hold an element nearer to a position than all others, and the
/// squared distances of their elements.
/// @param known some point is no farther away than this.
/// @param near room for all groups; set to those found, in the order of the list.
/// @param squared room for kLanes for each; set to the squared distances of their elements.
/// @param distance set to a bound of the least distance, no larger than `known`.
/// @return number of groups found.
MEDIAL_VECTORISED int groupsNear(const GroupList& list, const SiteGroup* groups,
  const glm::dvec3& x, float known, float slack, int* near, float* squared, float& distance)
{
  const glm::vec3 rounded(x);
  int count = 0;
  distance = known;
  for (std::size_t pack = 0; pack < list.discs().size(); ++pack)
  {
    const Discs& discs = list.discs()[pack];
    const DiscPosition position(discs, rounded);
    const float reach = distance + 2.0f * slack;
    const float limit = std::min(reach * reach * kRoundedUp, std::numeric_limits<float>::max());
    const Int8 met =
      (position.squaredDistance(discs) <= limit) & position.meetsRegions(discs, 0.0f);
    for (unsigned left = bits(met); left != 0; left &= left - 1)
    {
      const int id = list.groups()[pack * kLanes + __builtin_ctz(left)];
      const SiteGroup& group = groups[id];
      const glm::vec3 offset = group.toGroup(x);
      const Float8 candidate = ElementPosition(group, offset).squared;
      near[count] = id;
      store(candidate, squared + count * kLanes);
      ++count;
      if (bits(candidate < distance * distance) != 0)
      {
        float least = candidate[0];
        for (int lane = 1; lane < kLanes; ++lane)
        {
          least = std::min(least, candidate[lane]);
        }
        distance = std::min(distance, std::sqrt(least) + roundingFrom(offset, group.extent));
      }
    }
  }
  return count;
}

/// Keeps the groups that have elements within a squared distance. Returns their number.
MEDIAL_VECTORISED int keepWithin(float limit, int count, int* groups, const float* squared)
{
  int kept = 0;
  for (int i = 0; i < count; ++i)
  {
    const int group = groups[i];
    groups[kept] = group;
    kept += bits(loaded(squared + i * kLanes) <= limit) != 0 ? 1 : 0;
  }
  return kept;
}

/// Returns the elements of a group that own sites which can be closest in a box, as bits.
MEDIAL_VECTORISED unsigned ownersNear(const SiteGroup& group, const BoxReach& reach, float slack)
{
  const glm::vec3 offset = group.toGroup(glm::dvec3(reach.box().centre));
  const ElementPosition centre(group, offset);
  const Int8 parts = partsNear(group, AllElements(), centre,
    reach.radius() + slack + roundingFrom(offset, group.extent));
  return bits((parts != 0) & (centre.squared <= reach.squared()));
}

MEDIAL_INLINE float leastOf(Float8 values)
{
  float least = values[0];
  for (int lane = 1; lane < kLanes; ++lane)
  {
    least = std::min(least, values[lane]);
  }
  return least;
}

/// Returns the squared distances of a position from eight boxes.
template <typename Boxes>
MEDIAL_INLINE Float8 squaredDistances(const Boxes& boxes, const glm::vec3& x)
{
  Float8 squared{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const Float8 offset = x[axis] - loaded(boxes.centre[axis].data());
    const Float8 beyond = max(max(offset, -offset) - loaded(boxes.half[axis].data()), Float8{});
    squared += beyond * beyond;
  }
  return squared;
}

} // namespace

MEDIAL_VECTORISED void BlockQuery::PackBoxes::set(int lane, const SiteGroup& pack)
{
  const Float8 ab = loaded(pack.lengths[0].data());
  const Float8 ac = loaded(pack.lengths[2].data());
  const Float8 x = ac * loaded(pack.fromA[0].data());
  const Float8 y = ac * loaded(pack.fromA[1].data());
  for (int axis = 0; axis < 3; ++axis)
  {
    const Float8 along = loaded(pack.along[axis].data());
    const Float8 a = loaded(pack.start[axis].data());
    const Float8 b = a + ab * along;
    const Float8 c = a + x * along + y * loaded(pack.across[axis].data());
    const float low = leastOf(min(a, min(b, c)));
    const float high = -leastOf(min(-a, min(-b, -c)));
    centre[axis][lane] = 0.5f * (low + high);
    half[axis][lane] = 0.5f * (high - low);
  }
}

/// Finds the packs with elements as near to a position as a known point, and which of their sites
/// can be closest.
/// @param boxes around the packs.
/// @param extent of the packs.
/// @param distance of the known point, rounded up.
/// @param slack by how much Voronoi regions are widened, besides the rounding.
/// @param near room for all packs; set to those found.
/// @return number of packs found.
MEDIAL_VECTORISED int BlockQuery::packsNear(const SiteGroup* packs, const PackBoxes* boxes,
  int count, float extent, const glm::vec3& x, float distance, float slack, NearPack* near)
{
  const float rounding = roundingFrom(x, extent);
  float reach = distance + rounding;
  float limit = std::min(reach * reach, std::numeric_limits<float>::max());
  int found = 0;
  for (int first = 0; first < count; first += kLanes)
  {
    // No element of another pack is within reach.
    const float beyond = reach + rounding;
    unsigned left = ~bits(squaredDistances(boxes[first / kLanes], x) > beyond * beyond) & 0xffu;
    for (; left != 0; left &= left - 1)
    {
      const int i = first + __builtin_ctz(left);
      if (i >= count)
      {
        break;
      }
      const ElementPosition position(packs[i], x);
      const Int8 within = position.squared <= limit;
      if (bits(within) == 0)
      {
        continue;
      }
      const Int8 sites = partsNear(packs[i], AllElements(), position, slack + rounding) & within;
      near[found].pack = i;
      near[found].lanes = bits(sites != 0);
      std::memcpy(near[found].parts.data(), &sites, sizeof(sites));
      found += near[found].lanes != 0 ? 1 : 0;
      reach = std::min(reach, std::sqrt(leastOf(position.squared)) + 2.0f * rounding);
      limit = std::min(limit, reach * reach);
    }
  }
  return found;
}

BlockQuery::BlockQuery(const SiteQuery& query, const GroupTree& tree)
  : query_(query)
  , tree_(tree)
{
}

void BlockQuery::answer(std::vector<Question>& questions)
{
  order_.clear();
  for (Question& question : questions)
  {
    if (SiteQuery::inReach(question.x))
    {
      order_.push_back(&question);
    }
    else
    {
      question.closest = query_.closest(question.x, question.closest);
    }
  }
  if (!order_.empty())
  {
    this->prepare();
    this->answer({ order_.data(), order_.data() + order_.size() }, nullptr);
  }
}

void BlockQuery::prepare()
{
  SitePoint searched;
  int started = 0;
  for (Question* question : order_)
  {
    if (question->closest.site >= 0)
    {
      continue;
    }
    if (searched.site >= 0)
    {
      question->closest = closestPoint(tree_.sites(), searched.site, question->x);
    }
    if (started++ % kBetween == 0)
    {
      question->closest = searched = query_.closest(question->x, question->closest);
    }
  }
}

void BlockQuery::answer(const Block& block, const GroupList* near)
{
  if (near == nullptr && block.size() <= kCollected)
  {
    tree_.collect(reachOf(block, tree_.slack()), collected_);
    near = &collected_;
  }
  if (block.size() > kTogether)
  {
    Question** const middle = block.begin + block.size() / 2;
    halve(block.begin, middle, block.end);
    this->answer({ block.begin, middle }, near);
    this->answer({ middle, block.end }, near);
    return;
  }
  const BoxReach reach = reachOf(block, tree_.slack());
  near->find(reach, found_);
  const auto count = static_cast<int>(found_.size());
  if (count > kManyGroups)
  {
    this->searchEach(block);
    return;
  }
  if (count <= kFewGroups)
  {
    this->pack(*near, reach);
    this->answerFromPacks(block, reach);
    return;
  }
  groups_.assign(*near, found_);
  for (Question** question = block.begin; question != block.end; ++question)
  {
    this->answerFrom(groups_, **question);
  }
}

void BlockQuery::searchEach(const Block& block) const
{
  for (Question** question = block.begin; question != block.end; ++question)
  {
    (*question)->closest = query_.closest((*question)->x, (*question)->closest);
  }
}

BoxReach BlockQuery::reachOf(const Block& block, float slack)
{
  const FrameBox box = boxAround(block.begin, block.end);
  double farthest = 0.0;
  for (Question** at = block.begin; at != block.end; ++at)
  {
    const Question& question = **at;
    farthest = std::max(farthest,
      glm::distance(question.x, question.closest.point) +
        glm::distance(question.x, glm::dvec3(box.centre)));
  }
  return BoxReach(box, static_cast<float>(farthest) + 2.0f * slack);
}

NearestSite BlockQuery::startOf(const Question& question) const
{
  // Sites that others stand for are no answer.
  return tree_.sites().active(question.closest.site)
    ? NearestSite(tree_.sites(), question.x, question.closest, question.other)
    : NearestSite(tree_.sites(), question.x);
}

void BlockQuery::answerFrom(const GroupList& groups, Question& question)
{
  const std::size_t room = static_cast<std::size_t>(groups.size());
  near_.groups.resize(std::max(near_.groups.size(), room));
  near_.squared.resize(std::max(near_.squared.size(), room * kLanes));
  NearestSite nearest = this->startOf(question);
  const float known = distanceOf(question);
  float distance = known;
  int count = groupsNear(groups, tree_.groups().data(), question.x, known, tree_.slack(),
    near_.groups.data(), near_.squared.data(), distance);
  // Distances in single precision are off by less.
  const float reach = distance + 4.0f * tree_.slack();
  count = keepWithin(reach * reach * kRoundedUp, count, near_.groups.data(), near_.squared.data());
  SiteGroup::IntLanes parts;
  for (int i = 0; i < count; ++i)
  {
    const SiteGroup& group = tree_.groups()[near_.groups[i]];
    const glm::vec3 x = group.toGroup(question.x);
    nearest.offer(group, NearestSite::sitesNear(group, x, distance, tree_.slack(), parts), parts);
  }
  question.closest = nearest.closest();
}

void BlockQuery::pack(const GroupList& list, const BoxReach& reach)
{
  packed_ = 0;
  extent_ = 0.0f;
  for (const int place : found_)
  {
    const SiteGroup& group = tree_.groups()[list.groups()[place]];
    unsigned left = ownersNear(group, reach, tree_.slack());
    if (left == 0)
    {
      continue;
    }
    const glm::vec3 shift(group.origin - glm::dvec3(reach.box().centre));
    extent_ = std::max(extent_, glm::length(shift) + group.extent);
    for (; left != 0; left &= left - 1, ++packed_)
    {
      packs_.resize(std::max<std::size_t>(packs_.size(), packCount(packed_ + 1)));
      SiteGroup& pack = packs_[packed_ / kLanes];
      const int lane = packed_ % kLanes;
      pack.copy(lane, group, __builtin_ctz(left));
      for (int axis = 0; axis < 3; ++axis)
      {
        pack.start[axis][lane] += shift[axis];
      }
    }
  }
  for (int lane = packed_ % kLanes; lane != 0 && lane < kLanes; ++lane)
  {
    SiteGroup& last = packs_[packed_ / kLanes];
    last.copy(lane, last, lane - 1);
    last.owned[lane] = 0;
  }
  nearPacks_.resize(packs_.size());
  boxes_.resize(packCount(static_cast<int>(packs_.size())));
  for (int i = 0; i < packCount(packed_); ++i)
  {
    boxes_[i / kLanes].set(i % kLanes, packs_[i]);
  }
}

void BlockQuery::answerFromPacks(const Block& block, const BoxReach& reach)
{
  const int count = packCount(packed_);
  const glm::dvec3 centre(reach.box().centre);
  for (Question** at = block.begin; at != block.end; ++at)
  {
    Question& question = **at;
    const glm::vec3 x(question.x - centre);
    NearestSite nearest = this->startOf(question);
    const int found = packsNear(packs_.data(), boxes_.data(), count, extent_, x,
      distanceOf(question), tree_.slack(), nearPacks_.data());
    for (int i = 0; i < found; ++i)
    {
      const NearPack& near = nearPacks_[i];
      nearest.offer(packs_[near.pack], near.lanes, near.parts);
    }
    question.closest = nearest.closest();
  }
}

} // namespace medial

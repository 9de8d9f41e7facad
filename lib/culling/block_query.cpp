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
constexpr std::ptrdiff_t kTogether = BlockPositions::kMax;
/// From questions without a known point, one of this many is answered by a search. The others start
/// from its site.
constexpr int kBetween = 16;
/// With more groups than this near a block, a search for each question is faster.
constexpr int kManyGroups = 1024;
/// With at most this many, the questions of a block are answered together.
constexpr int kFewGroups = 64;

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
  const Int8 near = centre.squared <= reach.squared();
  if (bits(near) == 0)
  {
    return 0;
  }
  const Int8 parts = partsNear(group, AllElements(), centre,
    reach.radius() + slack + roundingFrom(offset, group.extent));
  return bits((parts != 0) & near);
}

} // namespace

double BlockQuery::Bounds::size() const
{
  const glm::dvec3 lengths = high - low;
  return lengths.x + lengths.y + lengths.z;
}

FrameBox BlockQuery::Bounds::box() const
{
  FrameBox box{ glm::vec3(0.5 * (low + high)), {} };
  const glm::dvec3 centre(box.centre);
  box.half = glm::vec3(glm::max(high - centre, centre - low)) * kRoundedUp;
  return box;
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
      order_.push_back({ &question, 0.0f });
    }
    else
    {
      question.closest = query_.closest(question.x, question.closest);
    }
  }
  if (!order_.empty())
  {
    this->prepare();
    const Block all{ order_.data(), order_.data() + order_.size(), 0 };
    this->bound(all);
    this->answer(all, nullptr);
  }
}

void BlockQuery::prepare()
{
  SitePoint searched;
  int started = 0;
  for (Asked& asked : order_)
  {
    Question& question = *asked.question;
    if (question.closest.site < 0)
    {
      if (searched.site >= 0)
      {
        question.closest = closestPoint(tree_.sites(), searched.site, question.x);
      }
      if (started++ % kBetween == 0)
      {
        question.closest = searched = query_.closest(question.x, question.closest);
      }
    }
    asked.known = distanceOf(question);
  }
}

void BlockQuery::bound(const Block& block)
{
  bounds_.resize(std::max(bounds_.size(), block.bounds + 1));
  if (block.size() > kTogether)
  {
    const Block first = block.first();
    const Block second = block.second();
    this->bound(first);
    this->bound(second);
    const Bounds& a = bounds_[first.bounds];
    const Bounds& b = bounds_[second.bounds];
    bounds_[block.bounds] = { glm::min(a.low, b.low), glm::max(a.high, b.high) };
    return;
  }
  Bounds bounds{ block.begin->question->x, block.begin->question->x };
  for (const Asked* asked = block.begin + 1; asked < block.end; ++asked)
  {
    bounds.low = glm::min(bounds.low, asked->question->x);
    bounds.high = glm::max(bounds.high, asked->question->x);
  }
  bounds_[block.bounds] = bounds;
}

void BlockQuery::halve(const Block& block)
{
  constexpr double kCompact = 1.7;
  const Block first = block.first();
  const Block second = block.second();
  const Bounds& whole = bounds_[block.bounds];
  if (bounds_[first.bounds].size() + bounds_[second.bounds].size() <= kCompact * whole.size())
  {
    return;
  }
  const int axis = longestAxis(whole.high - whole.low);
  std::nth_element(block.begin, first.end, block.end,
    [axis](const Asked& a, const Asked& b) { return a.question->x[axis] < b.question->x[axis]; });
  this->bound(first);
  this->bound(second);
}

void BlockQuery::answer(const Block& block, const std::vector<GroupPack>* near)
{
  if (near == nullptr && block.size() <= kCollected)
  {
    tree_.collect(this->reachOf(block), collected_);
    near = &collected_;
  }
  if (block.size() > kTogether)
  {
    this->halve(block);
    this->answer(block.first(), near);
    this->answer(block.second(), near);
    return;
  }
  const BoxReach reach = this->reachOf(block);
  const int count = this->findNear(reach, *near);
  if (count > kManyGroups)
  {
    this->searchEach(block);
    return;
  }
  if (count <= kFewGroups)
  {
    this->answerTogether(block, reach);
    return;
  }
  groups_.clear();
  for (const GroupPack& pack : found_)
  {
    for (unsigned left = pack.lanes; left != 0; left &= left - 1)
    {
      const int lane = __builtin_ctz(left);
      groups_.add(pack.group(lane), *pack.discs, lane);
    }
  }
  for (const Asked* asked = block.begin; asked != block.end; ++asked)
  {
    this->answerFrom(groups_, *asked);
  }
}

int BlockQuery::findNear(const BoxReach& reach, const std::vector<GroupPack>& groups)
{
  found_.clear();
  int count = 0;
  for (GroupPack pack : groups)
  {
    pack.lanes &= reach.meets(*pack.discs);
    if (pack.lanes != 0)
    {
      found_.push_back(pack);
      count += __builtin_popcount(pack.lanes);
    }
  }
  return count;
}

void BlockQuery::searchEach(const Block& block) const
{
  for (const Asked* asked = block.begin; asked != block.end; ++asked)
  {
    Question& question = *asked->question;
    question.closest = query_.closest(question.x, question.closest);
  }
}

BoxReach BlockQuery::reachOf(const Block& block) const
{
  const FrameBox box = bounds_[block.bounds].box();
  float farthest = 0.0f;
  for (const Asked* asked = block.begin; asked != block.end; ++asked)
  {
    farthest =
      std::max(farthest, asked->known + glm::distance(glm::vec3(asked->question->x), box.centre));
  }
  return BoxReach(box, farthest + 2.0f * tree_.slack());
}

NearestSite BlockQuery::startOf(const Question& question) const
{
  // Sites that others stand for are no answer.
  return tree_.sites().active(question.closest.site)
    ? NearestSite(tree_.sites(), question.x, question.closest, question.other)
    : NearestSite(tree_.sites(), question.x);
}

void BlockQuery::answerFrom(const GroupList& groups, const Asked& asked)
{
  Question& question = *asked.question;
  const std::size_t room = static_cast<std::size_t>(groups.size());
  near_.groups.resize(std::max(near_.groups.size(), room));
  near_.squared.resize(std::max(near_.squared.size(), room * kLanes));
  NearestSite nearest = this->startOf(question);
  float distance = asked.known;
  int count = groupsNear(groups, tree_.groups().data(), question.x, asked.known, tree_.slack(),
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

void BlockQuery::answerTogether(const Block& block, const BoxReach& reach)
{
  const glm::dvec3 centre(reach.box().centre);
  positions_.clear();
  nearest_.clear();
  for (const Asked* asked = block.begin; asked != block.end; ++asked)
  {
    positions_.add(glm::vec3(asked->question->x - centre), asked->known);
    nearest_.push_back(this->startOf(*asked->question));
  }
  for (const GroupPack& pack : found_)
  {
    for (unsigned left = pack.lanes; left != 0; left &= left - 1)
    {
      const SiteGroup& group = tree_.groups()[pack.group(__builtin_ctz(left))];
      const unsigned elements = ownersNear(group, reach, tree_.slack());
      if (elements == 0)
      {
        continue;
      }
      const glm::vec3 shift(group.origin - centre);
      const int count = positions_.find(group, elements, shift, tree_.slack(), nearSites_);
      for (int i = 0; i < count; ++i)
      {
        this->offer(group, nearSites_[i]);
      }
    }
  }
  for (std::ptrdiff_t i = 0; i < block.size(); ++i)
  {
    block.begin[i].question->closest = nearest_[i].closest();
  }
}

void BlockQuery::offer(const SiteGroup& group, const BlockPositions::Near& near)
{
  unsigned all = 0;
  for (unsigned left = near.positions; left != 0; left &= left - 1)
  {
    all |= static_cast<unsigned>(near.parts[__builtin_ctz(left)]);
  }
  for (; all != 0; all &= all - 1)
  {
    const int part = __builtin_ctz(all);
    const int site = siteOf(tree_.sites(), group, near.element, part);
    for (unsigned left = near.positions; left != 0; left &= left - 1)
    {
      const int lane = __builtin_ctz(left);
      if ((near.parts[lane] >> part & 1) != 0)
      {
        nearest_[near.first + lane].offer(site);
      }
    }
  }
}

} // namespace medial

#include "culling/block_query.h"

#include "base/longest_axis.h"
#include "culling/nearest_element.h"
#include "culling/nearest_site.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Number of questions in a block. With fewer, finding the elements costs more than it saves.
constexpr std::ptrdiff_t kTogether = 32;
/// From questions without a known point, one of this many is answered by a search. The others start
/// from its site.
constexpr int kBetween = 16;
/// With more groups than this near a block, a search for each question is faster.
constexpr int kManyGroups = 256;

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

/// Of the known points of questions, those nearest to the centre and to the corners of a box.
struct alignas(32) KnownPoints
{
  float squared = std::numeric_limits<float>::infinity(); ///< of the least distance to the centre
  std::array<int, FrameBox::kCorners> nearest{};          ///< question for every corner
};

MEDIAL_VECTORISED void findKnown(const SiteQuery::Question* const* questions, int count,
  const FrameBox& box, KnownPoints& known)
{
  std::array<Float8, 3> corners;
  constexpr Float8 kSigns[3] = { { -1, 1, -1, 1, -1, 1, -1, 1 }, { -1, -1, 1, 1, -1, -1, 1, 1 },
    { -1, -1, -1, -1, 1, 1, 1, 1 } };
  for (int axis = 0; axis < 3; ++axis)
  {
    corners[axis] = kSigns[axis] * box.half[axis];
  }
  Float8 least = splat(std::numeric_limits<float>::infinity());
  Int8 nearest{};
  for (int i = 0; i < count; ++i)
  {
    const glm::vec3 offset(glm::dvec3(box.centre) - questions[i]->closest.point);
    Float8 squared{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const Float8 along = corners[axis] + offset[axis];
      squared += along * along;
    }
    const Int8 nearer = squared < least;
    least = nearer ? squared : least;
    nearest = nearer ? Int8{} + i : nearest;
    known.squared = std::min(known.squared, glm::dot(offset, offset));
  }
  std::memcpy(known.nearest.data(), &nearest, sizeof(nearest));
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

/// Finds the squared distances of a position from packed elements, and returns the least distance.
MEDIAL_VECTORISED float nearestOf(const SiteGroup* packs, int count, const glm::vec3& x,
  float* squared)
{
  Float8 least = splat(std::numeric_limits<float>::infinity());
  for (int i = 0; i < count; ++i)
  {
    const Float8 candidate = ElementPosition(packs[i], x).squared;
    store(candidate, squared + i * kLanes);
    least = min(least, candidate);
  }
  float nearest = least[0];
  for (int lane = 1; lane < kLanes; ++lane)
  {
    nearest = std::min(nearest, least[lane]);
  }
  return std::sqrt(nearest);
}

MEDIAL_VECTORISED bool anyWithin(const float* squared, float limit)
{
  return bits(loaded(squared) <= limit) != 0;
}

} // namespace

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
    this->answer({ order_.data(), order_.data() + order_.size() });
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

void BlockQuery::answer(const Block& block)
{
  if (block.size() > kTogether)
  {
    const int axis = longestAxis(glm::dvec3(boxAround(block.begin, block.end).half));
    Question** const middle = block.begin + block.size() / 2;
    std::nth_element(block.begin, middle, block.end,
      [axis](const Question* a, const Question* b) { return a->x[axis] < b->x[axis]; });
    this->answer({ block.begin, middle });
    this->answer({ middle, block.end });
    return;
  }
  const BoxReach reach = this->reachOf(block);
  tree_.collect(reach, groups_);
  if (groups_.size() > kManyGroups)
  {
    this->searchEach(block);
    return;
  }
  this->pack(reach);
  this->answerFromPacks(block, reach);
}

void BlockQuery::searchEach(const Block& block) const
{
  for (Question** question = block.begin; question != block.end; ++question)
  {
    (*question)->closest = query_.closest((*question)->x, (*question)->closest);
  }
}

BoxReach BlockQuery::reachOf(const Block& block) const
{
  const FrameBox box = boxAround(block.begin, block.end);
  KnownPoints known;
  findKnown(block.begin, static_cast<int>(block.size()), box, known);
  NearestElement nearest;
  nearest.squared = known.squared;
  BoxReach reach(box, nearest, tree_.slack());
  std::sort(known.nearest.begin(), known.nearest.end());
  const auto end = std::unique(known.nearest.begin(), known.nearest.end());
  std::for_each(known.nearest.begin(), end,
    [&](int i) { reach.add(glm::vec3(block.begin[i]->closest.point)); });
  return reach;
}

void BlockQuery::pack(const BoxReach& reach)
{
  packed_ = 0;
  extent_ = 0.0f;
  for (const int id : groups_.groups())
  {
    const SiteGroup& group = tree_.groups()[id];
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
  for (int i = 0; i < packCount(packed_); ++i)
  {
    packs_[i].extent = extent_;
  }
  squared_.resize(std::max(squared_.size(), packs_.size() * kLanes));
}

void BlockQuery::answerFromPacks(const Block& block, const BoxReach& reach)
{
  const int count = packCount(packed_);
  const glm::dvec3 centre(reach.box().centre);
  SiteGroup::IntLanes parts;
  for (Question** at = block.begin; at != block.end; ++at)
  {
    Question& question = **at;
    const glm::vec3 x(question.x - centre);
    const float rounding = roundingFrom(x, extent_);
    const float distance = nearestOf(packs_.data(), count, x, squared_.data()) + rounding;
    const float limit = (distance + rounding) * (distance + rounding);
    NearestSite nearest(tree_.sites(), question.x);
    for (int i = 0; i < count; ++i)
    {
      if (anyWithin(&squared_[i * kLanes], limit))
      {
        nearest.offer(packs_[i],
          NearestSite::sitesNear(packs_[i], x, distance, tree_.slack(), parts), parts);
      }
    }
    question.closest = nearest.closest();
  }
}

} // namespace medial

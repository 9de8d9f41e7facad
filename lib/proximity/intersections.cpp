#include "proximity/intersections.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{

constexpr std::size_t kParts = 24;

void findInLeaves(const MovingMesh& a, const MovingMesh& b, const NodePair& pair, bool all,
  const glm::dvec3& moved, std::vector<SlotPair>& found)
{
  const BoxTree::Node& nodeA = a.tree().nodes()[pair.a];
  const BoxTree::Node& nodeB = b.tree().nodes()[pair.b];
  for (int i = nodeA.first; i < nodeA.first + nodeA.count; ++i)
  {
    const Box boxA = a.boxOf(i).moved(moved);
    if (!boxA.overlaps(nodeB.box))
    {
      continue;
    }
    for (int k = nodeB.first; k < nodeB.first + nodeB.count; ++k)
    {
      if (boxA.overlaps(b.boxOf(k)) && intersect(a.element(i).moved(moved), b.element(k)))
      {
        found.push_back({ i, k });
        if (!all)
        {
          return;
        }
      }
    }
  }
}

void search(const MovingMesh& a, const MovingMesh& b, const NodePair& start, bool all,
  std::vector<SlotPair>& found, const glm::dvec3& moved = glm::dvec3(0.0))
{
  constexpr double kEnd = -1.0;
  walkPairs(
    a.tree(), b.tree(), start, [&] { return all || found.empty() ? 0.0 : kEnd; },
    [&](const NodePair& pair) { findInLeaves(a, b, pair, all, moved, found); }, moved);
}

NodePair roots(const MovingMesh& a, const MovingMesh& b, const glm::dvec3& moved = glm::dvec3(0.0))
{
  return { 0, 0, a.tree().box().moved(moved).squaredDistance(b.tree().box()) };
}

} // namespace

PairCrossings crossingsOf(const Element& a, const Element& b)
{
  PairCrossings found;
  for (const auto& [edges, triangle] : { std::pair(&a, &b), std::pair(&b, &a) })
  {
    for (int i = 0; i < 3; ++i)
    {
      found.count += crossing(edges->corners[i], edges->corners[(i + 1) % 3], *triangle,
                       found.points[found.count])
        ? 1
        : 0;
    }
  }
  return found;
}

bool intersect(const MovingMesh& a, const glm::dvec3& translation, const MovingMesh& b)
{
  std::vector<SlotPair> found;
  search(a, b, roots(a, b, translation), false, found, translation);
  return !found.empty();
}

void Intersections::findCrossings(const MovingMesh& a, const MovingMesh& b)
{
  constexpr std::size_t kTogether = 16;
  crossings_.resize(pairs_.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pairs_.size(), kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
      {
        crossings_[i] = crossingsOf(a.element(pairs_[i].a), b.element(pairs_[i].b));
      }
    });
}

void Intersections::find(const MovingMesh& a, const MovingMesh& b, bool all)
{
  pairs_.clear();
  crossings_.clear();
  if (!all)
  {
    if (last_.a >= 0 && intersect(a.element(a.slotOf(last_.a)), b.element(b.slotOf(last_.b))))
    {
      pairs_.push_back({ a.slotOf(last_.a), b.slotOf(last_.b) });
      return;
    }
    search(a, b, roots(a, b), all, pairs_);
  }
  else
  {
    parts_.split(a.tree(), b.tree(), 0.0, kParts);
    found_.resize(std::max(found_.size(), parts_.pairs().size()));
    tbb::parallel_for(std::size_t{ 0 }, parts_.pairs().size(),
      [&](std::size_t i)
      {
        found_[i].clear();
        search(a, b, parts_.pairs()[i], all, found_[i]);
      });
    for (std::size_t i = 0; i < parts_.pairs().size(); ++i)
    {
      pairs_.insert(pairs_.end(), found_[i].begin(), found_[i].end());
    }
    // By elements: slots depend on how the trees were built.
    const auto elements = [&](const SlotPair& pair)
    { return std::pair(a.elementIn(pair.a), b.elementIn(pair.b)); };
    std::sort(pairs_.begin(), pairs_.end(),
      [&](const SlotPair& p, const SlotPair& q) { return elements(p) < elements(q); });
    this->findCrossings(a, b);
  }
  last_ = pairs_.empty() ? SlotPair{ -1, -1 }
                         : SlotPair{ a.elementIn(pairs_[0].a), b.elementIn(pairs_[0].b) };
}

} // namespace medial

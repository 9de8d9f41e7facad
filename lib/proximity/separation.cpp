#include "proximity/separation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <tuple>

namespace medial
{
namespace
{

constexpr std::size_t kParts = 24;
bool isBetter(const ClosestElements& x, const ClosestElements& y)
{
  return std::tie(x.points.squared, x.elementA, x.elementB) <
    std::tie(y.points.squared, y.elementA, y.elementB);
}

void tryElements(const MovingMesh& a, int slotA, const MovingMesh& b, int slotB,
  ClosestElements& best)
{
  const ClosestElements found{ closestPoints(a.element(slotA), b.element(slotB)),
    a.elementIn(slotA), b.elementIn(slotB) };
  if (isBetter(found, best))
  {
    best = found;
  }
}

void tryLeaves(const MovingMesh& a, const MovingMesh& b, const NodePair& pair,
  ClosestElements& best)
{
  const BoxTree::Node& nodeA = a.tree().nodes()[pair.a];
  const BoxTree::Node& nodeB = b.tree().nodes()[pair.b];
  for (int i = nodeA.first; i < nodeA.first + nodeA.count; ++i)
  {
    const Box boxA = a.boxOf(i);
    if (boxA.squaredDistance(nodeB.box) > best.points.squared * Box::kRoundedUp)
    {
      continue;
    }
    for (int k = nodeB.first; k < nodeB.first + nodeB.count; ++k)
    {
      if (boxA.squaredDistance(b.boxOf(k)) <= best.points.squared * Box::kRoundedUp)
      {
        tryElements(a, i, b, k, best);
      }
    }
  }
}

void search(const MovingMesh& a, const MovingMesh& b, const NodePair& start, ClosestElements& best)
{
  walkPairs(
    a.tree(), b.tree(), start, [&] { return best.points.squared * Box::kRoundedUp; },
    [&](const NodePair& pair) { tryLeaves(a, b, pair, best); });
}

} // namespace

ClosestElements Separation::first(const MovingMesh& a, const MovingMesh& b,
  const ClosestElements& last)
{
  ClosestElements best;
  if (last.elementA >= 0)
  {
    tryElements(a, a.slotOf(last.elementA), b, b.slotOf(last.elementB), best);
    return best;
  }
  NodePair pair;
  while (!areLeaves(a.tree(), b.tree(), pair))
  {
    PairChildren children(a.tree(), b.tree(), pair);
    children.sort();
    pair = *(children.end() - 1);
  }
  tryLeaves(a, b, pair, best);
  return best;
}

const ClosestElements& Separation::find(const MovingMesh& a, const MovingMesh& b)
{
  ClosestElements best = first(a, b, last_);
  parts_.split(a.tree(), b.tree(), best.points.squared * Box::kRoundedUp, kParts);
  if (!parts_.pairs().empty()) // boxes may seem farther apart than what is in them
  {
    search(a, b, parts_.pairs().front(), best);
  }
  // All parts start with the same bound, so that what one of them finds does not depend on others.
  found_.assign(std::max<std::size_t>(1, parts_.pairs().size()), best);
  tbb::parallel_for(std::size_t{ 1 }, found_.size(),
    [&](std::size_t i) { search(a, b, parts_.pairs()[i], found_[i]); });
  last_ = *std::min_element(found_.begin(), found_.end(), isBetter);
  return last_;
}

} // namespace medial

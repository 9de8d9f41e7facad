#include "proximity/contact_manifolds.h"

#include <algorithm>
#include <tuple>

namespace medial
{

void ContactManifolds::find(const MovingMesh& a, const MovingMesh& b,
  const std::vector<SlotPair>& pairs, const Penetration& aInB, const Penetration& bInA)
{
  a_ = &a;
  b_ = &b;
  aInB_ = &aInB;
  bInA_ = &bInA;
  firstA_ = pairs.size();
  firstB_ = firstA_ + aInB.enclosed().points().size();
  const std::size_t all = firstB_ + bInA.enclosed().points().size();
  sets_.reset(all);
  this->joinPairs(b, pairs, &SlotPair::a, &SlotPair::b);
  this->joinPairs(a, pairs, &SlotPair::b, &SlotPair::a);
  const auto listFirst = [&](int SlotPair::*slot, std::vector<FirstPair>& slots)
  {
    slots.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      slots.push_back({ pairs[i].*slot, static_cast<int>(i) });
    }
    std::sort(slots.begin(), slots.end(),
      [](const FirstPair& p, const FirstPair& q)
      { return std::tie(p.slot, p.pair) < std::tie(q.slot, q.pair); });
  };
  listFirst(&SlotPair::a, slotsA_);
  listFirst(&SlotPair::b, slotsB_);
  this->joinEnclosed(a, aInB, slotsA_, firstA_);
  this->joinEnclosed(b, bInA, slotsB_, firstB_);
  manifolds_.resize(all);
  count_ = 0;
  for (std::size_t i = 0; i < all; ++i)
  {
    const auto first = static_cast<std::size_t>(sets_.find(static_cast<std::int64_t>(i)));
    manifolds_[i] = first == i ? count_++ : manifolds_[first]; // the lowest of a set comes first
  }
}

void ContactManifolds::joinPairs(const MovingMesh& mesh, const std::vector<SlotPair>& pairs,
  int SlotPair::*fixed, int SlotPair::*other)
{
  corners_.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      corners_.push_back(
        { pairs[i].*fixed, mesh.corners(pairs[i].*other)[k], static_cast<int>(i) });
    }
  }
  std::sort(corners_.begin(), corners_.end(),
    [](const Corner& p, const Corner& q)
    { return std::tie(p.slot, p.point, p.pair) < std::tie(q.slot, q.point, q.pair); });
  for (std::size_t i = 1; i < corners_.size(); ++i)
  {
    const Corner& last = corners_[i - 1];
    if (corners_[i].slot == last.slot && corners_[i].point == last.point)
    {
      sets_.join(last.pair, corners_[i].pair);
    }
  }
}

int ContactManifolds::firstPair(const std::vector<FirstPair>& slots, int slot)
{
  const auto found = std::lower_bound(slots.begin(), slots.end(), slot,
    [](const FirstPair& entry, int wanted) { return entry.slot < wanted; });
  return found != slots.end() && found->slot == slot ? found->pair : -1;
}

void ContactManifolds::joinEnclosed(const MovingMesh& mesh, const Penetration& penetration,
  const std::vector<FirstPair>& slots, std::size_t first)
{
  const auto& points = penetration.enclosed().points();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto node = static_cast<std::int64_t>(first + i);
    if (points[i].from >= 0)
    {
      sets_.join(node, static_cast<std::int64_t>(first) + points[i].from);
    }
    const IncidenceLists& around = mesh.pointSlots();
    for (const int* slot = around.begin(points[i].point); slot != around.end(points[i].point);
         ++slot)
    {
      if (penetration.enclosed().isCut(*slot))
      {
        sets_.join(node, firstPair(slots, *slot));
      }
    }
  }
}

int ContactManifolds::ofSlot(const DeepPlace& place) const
{
  if (place.mesh == nullptr)
  {
    return -1;
  }
  return place.mesh == a_ ? this->manifoldOf(place.slot, *a_, slotsA_, firstA_, *aInB_)
                          : this->manifoldOf(place.slot, *b_, slotsB_, firstB_, *bInA_);
}

int ContactManifolds::manifoldOf(int slot, const MovingMesh& mesh,
  const std::vector<FirstPair>& slots, std::size_t first, const Penetration& penetration) const
{
  const int pair = firstPair(slots, slot);
  if (pair >= 0)
  {
    return manifolds_[pair];
  }
  const int point = mesh.corners(slot)[0];
  return penetration.enclosed().isInside(point)
    ? manifolds_[first + penetration.enclosed().indexOf(point)]
    : -1;
}

} // namespace medial

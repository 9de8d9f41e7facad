#include "proximity/pair_proximity.h"

#include "base/vectors.h"
#include "proximity/element_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

/// Depths that are not known.
void leaveOpen(Proximity& result)
{
  result.depth = std::numeric_limits<double>::quiet_NaN();
  result.depthAtMost = result.depth;
  result.translationalDepth.upper = std::numeric_limits<double>::infinity();
}

const DeepPlace& deeper(const DeepPlace& p, const DeepPlace& q)
{
  return q.depth > p.depth ? q : p;
}

/// Lists the slots of either mesh, by ascending elements.
void listSlots(const MovingMesh& mesh, const std::vector<SlotPair>& pairs, int SlotPair::*slot,
  std::vector<int>& slots)
{
  slots.clear();
  for (const SlotPair& pair : pairs)
  {
    slots.push_back(pair.*slot);
  }
  std::sort(slots.begin(), slots.end(),
    [&](int p, int q) { return mesh.elementIn(p) < mesh.elementIn(q); });
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
}

/// Lists the crossings of either mesh's elements, by ascending slots.
void listCrossings(const Intersections& intersections, int SlotPair::*slot,
  std::vector<CutPlace>& places)
{
  places.clear();
  for (std::size_t i = 0; i < intersections.pairs().size(); ++i)
  {
    int k = 0;
    for (const glm::dvec3& point : intersections.crossings()[i])
    {
      places.push_back({ intersections.pairs()[i].*slot, static_cast<int>(i), k++, point });
    }
  }
  std::sort(places.begin(), places.end(),
    [](const CutPlace& p, const CutPlace& q)
    { return std::tie(p.slot, p.pair, p.crossing) < std::tie(q.slot, q.pair, q.crossing); });
}

void listDepths(const Penetration& penetration, std::vector<PointDepth>& depths)
{
  depths.clear();
  const auto& points = penetration.enclosed().points();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    depths.push_back({ points[i].point, penetration.depthOf(i) });
  }
  std::sort(depths.begin(), depths.end(),
    [](const PointDepth& p, const PointDepth& q) { return p.point < q.point; });
}

} // namespace

PairProximity::PairProximity(const MovingMesh& a, const MovingMesh& b, const SolidQuery& solidA,
  const SolidQuery& solidB)
  : a_(a)
  , b_(b)
  , aInB_(a, b, solidB)
  , bInA_(b, a, solidA)
  , contacts_(a, b, solidA, solidB)
  , translationalDepth_(a, b, solidA, solidB)
{
}

void PairProximity::compute(const ProximityOptions& options, Proximity& result)
{
  const bool near = a_.tree().box().overlaps(b_.tree().box());
  intersections_.find(a_, b_, options.depths);
  result.intersect = !intersections_.pairs().empty();
  if (result.intersect)
  {
    this->meet(result);
  }
  else if (options.separation)
  {
    this->separate(result);
  }
  else
  {
    result.separation = std::numeric_limits<double>::quiet_NaN();
  }
  listSlots(a_, intersections_.pairs(), &SlotPair::a, cutA_);
  listSlots(b_, intersections_.pairs(), &SlotPair::b, cutB_);
  result.collide = result.intersect;
  if (result.intersect && !options.depths)
  {
    leaveOpen(result);
  }
  else if (near) // nothing is inside the other otherwise
  {
    this->penetrate(options, result);
  }
}

void PairProximity::separate(Proximity& result)
{
  const ClosestElements& closest = separation_.find(a_, b_);
  // Squares of tiny distances are 0.
  result.separation =
    std::max(std::sqrt(closest.points.squared), std::numeric_limits<double>::min());
  result.witnessA = toPoint(closest.points.a);
  result.witnessB = toPoint(closest.points.b);
  result.cellA = a_.cellOf(a_.slotOf(closest.elementA));
  result.cellB = b_.cellOf(b_.slotOf(closest.elementB));
}

void PairProximity::meet(Proximity& result)
{
  const SlotPair& pair = intersections_.pairs().front();
  const Element a = a_.element(pair.a);
  const Element b = b_.element(pair.b);
  const PairCrossings crossings =
    intersections_.crossings().empty() ? crossingsOf(a, b) : intersections_.crossings().front();
  // Where there are none, they touch with their edges or lie in one plane.
  const glm::dvec3 common = crossings.count > 0 ? crossings.points[0] : closestPoints(a, b).a;
  result.witnessA = toPoint(common);
  result.witnessB = result.witnessA;
  result.cellA = a_.cellOf(pair.a);
  result.cellB = b_.cellOf(pair.b);
}

void PairProximity::penetrate(const ProximityOptions& options, Proximity& result)
{
  const std::pair<Penetration*, const std::vector<int>*> ways[] = { { &aInB_, &cutA_ },
    { &bInA_, &cutB_ } };
  const auto both = [&](const auto& work)
  { tbb::parallel_for(0, 2, [&](int i) { work(i, *ways[i].first, *ways[i].second); }); };
  both([&](int, Penetration& way, const std::vector<int>& cut) { way.find(cut, options.depths); });
  result.insideUndefined = aInB_.enclosed().anyUndefined() || bInA_.enclosed().anyUndefined();
  result.collide =
    result.intersect || !aInB_.enclosed().points().empty() || !bInA_.enclosed().points().empty();
  if (!result.collide && !result.insideUndefined)
  {
    return;
  }
  leaveOpen(result);
  if (result.insideUndefined || !options.depths)
  {
    return;
  }
  constexpr double kAbsolute = 1e-5;
  const double absolute =
    kAbsolute * std::min(glm::length(a_.tree().box().size()), glm::length(b_.tree().box().size()));
  listCrossings(intersections_, &SlotPair::a, crossings_[0]);
  listCrossings(intersections_, &SlotPair::b, crossings_[1]);
  DeepPlace deepest = deeper(aInB_.deepestPoint(), bInA_.deepestPoint());
  DeepPlace found[2];
  both([&](int i, Penetration& way, const std::vector<int>& cut)
    { found[i] = way.deepest(cut, crossings_[i], deepest, options.depthTolerance, absolute); });
  deepest = deeper(found[0], found[1]);
  result.depth = deepest.depth;
  result.depthAtMost = std::max(aInB_.deepestAtMost(), bInA_.deepestAtMost());
  result.deepestPoint = toPoint(deepest.point);
  listDepths(aInB_, result.depthsOfA);
  listDepths(bInA_, result.depthsOfB);
  this->listDirections(deepest);
  tbb::parallel_for(0, 2,
    [&](int task)
    {
      if (task == 0 && options.maxContacts > 0)
      {
        contacts_.find(intersections_, aInB_, bInA_, deepest, options.maxContacts, result.contacts);
      }
      if (task == 1 && options.translationalDepth)
      {
        glm::dvec3 translation;
        result.translationalDepth = translationalDepth_.find(deepest, directions_, translation);
        result.separatingTranslation = toPoint(translation);
      }
    });
}

void PairProximity::listDirections(const DeepPlace& deepest)
{
  directions_.clear();
  // Of A, out of B: what is inside A moves the other way.
  const auto wayOut = [&](const DeepPlace& place)
  { return place.mesh == &a_ ? place.closest - place.point : place.point - place.closest; };
  glm::dvec3 sum(0.0);
  for (const Penetration* way : { &aInB_, &bInA_ })
  {
    for (std::size_t i = 0; i < way->closest().size(); ++i)
    {
      sum += wayOut(way->placeOf(i));
    }
  }
  for (const glm::dvec3& direction : { wayOut(deepest), sum })
  {
    const double length = glm::length(direction);
    if (length > 0.0)
    {
      directions_.push_back(direction / length);
    }
  }
}

} // namespace medial

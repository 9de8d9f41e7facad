#include "proximity/contacts.h"

#include "base/vectors.h"
#include "proximity/element_distance.h"
#include "proximity/line_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

/// Depths below this multiple of the coordinates' rounding are those of surfaces that touch.
constexpr double kTouching = 64.0;
/// How far rounding moves a place, as a multiple of the coordinates' rounding.
constexpr double kRounded = 8.0;
/// Positions nearer than this share of a manifold's extent count as one.
constexpr double kMerged = 1e-6;
/// How far a crossing is moved into a manifold to find the overlap's thickness, as a share of its
/// extent, and at most as a share of its depth.
constexpr double kInwards = 1e-7;
constexpr double kInwardsOfDepth = 1e-3;
/// How far it is moved along the normal if that is not inside, as a multiple of that.
constexpr double kOffBorder = 8.0;
/// Crossings where the overlap is thinner than this share of its depth are none of its corners.
constexpr double kShallow = 0.01;

glm::dvec3 normalised(const glm::dvec3& vector)
{
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

/// How much the last bit of the largest coordinate is.
double roundingOf(const Box& a, const Box& b)
{
  const glm::dvec3 largest = glm::max(glm::max(glm::abs(a.min), glm::abs(a.max)),
    glm::max(glm::abs(b.min), glm::abs(b.max)));
  return std::numeric_limits<double>::epsilon() * std::max({ largest.x, largest.y, largest.z });
}

double extentOf(const std::vector<ContactPlace>& places)
{
  Box box;
  for (const ContactPlace& place : places)
  {
    box.add(place.point);
  }
  return places.empty() ? 0.0 : glm::length(box.size());
}

double maxDepth(const std::vector<ContactPlace>& places)
{
  double max = 0.0;
  for (const ContactPlace& place : places)
  {
    max = std::max(max, place.depth);
  }
  return max;
}

/// Whether a place is on the flank of what is pressed in, as a point of the ground is in the wedge
/// above an edge: shallow, with another direction.
bool isBesides(const ContactPlace& place, const glm::dvec3& normal, double max)
{
  constexpr double kDeep = 0.5;
  constexpr double kCosine = 0.866; // of 30 degrees
  return !place.isCrossing && place.depth > kShallow * max && place.depth < kDeep * max &&
    glm::dot(place.normal, normal) < kCosine;
}

} // namespace

void Contacts::find(const Intersections& intersections, const Penetration& aInB,
  const Penetration& bInA, const DeepPlace& deepest, int maxContacts,
  std::vector<ProximityContact>& contacts)
{
  rounding_ = roundingOf(a_.tree().box(), b_.tree().box());
  split_.find(a_, b_, intersections.pairs(), aInB, bInA);
  this->collect(intersections, aInB, bInA, deepest);
  int number = 0;
  for (int i = 0; i < split_.count(); ++i)
  {
    Manifold& manifold = manifolds_[i];
    this->reduce(manifold, maxContacts);
    for (const ContactPlace& place : manifold.places)
    {
      contacts.push_back({ toPoint(place.point), toPoint(place.normal), place.depth, number,
        a_.cellOf(place.slotA), b_.cellOf(place.slotB) });
    }
    number += manifold.places.empty() ? 0 : 1;
  }
}

void Contacts::collect(const Intersections& intersections, const Penetration& aInB,
  const Penetration& bInA, const DeepPlace& deepest)
{
  const std::vector<SlotPair>& pairs = intersections.pairs();
  manifolds_.resize(std::max<std::size_t>(manifolds_.size(), split_.count()));
  for (Manifold& manifold : manifolds_)
  {
    manifold.places.clear();
    manifold.pairs.clear();
    manifold.uncrossed.clear();
  }
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    Manifold& manifold = manifolds_[split_.ofPair(i)];
    manifold.pairs.push_back(pairs[i]);
    if (intersections.crossings()[i].count == 0)
    {
      manifold.uncrossed.push_back(pairs[i]);
    }
    for (const glm::dvec3& point : intersections.crossings()[i])
    {
      ContactPlace place;
      place.point = point;
      place.isCrossing = true;
      place.slotA = pairs[i].a;
      place.slotB = pairs[i].b;
      manifold.places.push_back(place);
    }
  }
  for (std::size_t i = 0; i < aInB.closest().size(); ++i)
  {
    this->addPlace(aInB.placeOf(i), split_.ofEnclosedA(i));
  }
  for (std::size_t i = 0; i < bInA.closest().size(); ++i)
  {
    this->addPlace(bInA.placeOf(i), split_.ofEnclosedB(i));
  }
  for (int i = 0; i < split_.count(); ++i)
  {
    Manifold& manifold = manifolds_[i];
    // Elements that touch with their edges, or that lie in one plane.
    if (manifold.places.empty())
    {
      const SlotPair& pair = manifold.pairs.front();
      ContactPlace place;
      place.point = closestPoints(a_.element(pair.a), b_.element(pair.b)).a;
      place.slotA = pair.a;
      place.slotB = pair.b;
      manifold.places.push_back(place);
    }
  }
  // The deepest place may lie in the middle of a face.
  const int manifold = split_.ofSlot(deepest);
  if (manifold >= 0)
  {
    this->addPlace(deepest, manifold);
  }
}

void Contacts::addPlace(const DeepPlace& found, int manifold)
{
  const bool ofA = found.mesh == &a_;
  ContactPlace place;
  place.point = found.point;
  place.depth = found.depth;
  place.slotA = ofA ? found.slot : found.otherSlot;
  place.slotB = ofA ? found.otherSlot : found.slot;
  const glm::dvec3 out = this->wayOut(found);
  place.normal = ofA ? -out : out;
  manifolds_[manifold].places.push_back(place);
}

glm::dvec3 Contacts::wayOut(const DeepPlace& place) const
{
  const glm::dvec3 out = normalised(place.closest - place.point);
  // Rounding turns the direction of a shallow place; the face that it leads to knows better.
  const glm::dvec3 face = outwardNormal(place.mesh == &a_ ? b_ : a_, place.otherSlot);
  const glm::dvec3 across = glm::dot(face, out) < 0.0 ? -face : face;
  return face != glm::dvec3(0.0) &&
      place.depth * glm::distance(across, out) <= kTouching * rounding_
    ? across
    : out;
}

void Contacts::addTouches(Manifold& manifold) const
{
  const double near = kTouching * rounding_;
  for (const SlotPair& pair : manifold.uncrossed)
  {
    const Element a = a_.element(pair.a);
    const Element b = b_.element(pair.b);
    const auto add = [&](const glm::dvec3& x)
    {
      ContactPlace place;
      place.point = x;
      place.isCrossing = true;
      place.slotA = pair.a;
      place.slotB = pair.b;
      manifold.places.push_back(place);
    };
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const ClosePoints edges = closestPoints(edgeOf(a, i), edgeOf(b, k));
        if (edges.squared <= near * near)
        {
          add(edges.a);
        }
      }
      for (const auto& [corner, other] :
        { std::pair(&a.corners[i], &b), std::pair(&b.corners[i], &a) })
      {
        if (isNear(*other, *corner, near))
        {
          add(*corner);
        }
      }
    }
  }
}

void Contacts::reduce(Manifold& manifold, int maxContacts)
{
  manifold.normal = this->findNormal(manifold);
  std::vector<ContactPlace>& places = manifold.places;
  if (places.empty())
  {
    return;
  }
  const ContactPlane plane(manifold.normal, places.front().point);
  const double extent = extentOf(places);
  const double merged = std::max(kMerged * extent, kRounded * rounding_);
  const double max = maxDepth(places);
  places.erase(std::remove_if(places.begin(), places.end(),
                 [&](const ContactPlace& place) { return isBesides(place, manifold.normal, max); }),
    places.end());
  for (ContactPlace& place : places)
  {
    // Points on the other surface are crossings, too, and no depth along the normal.
    if (place.depth < kShallow * max)
    {
      place.isCrossing = true;
      place.normal = glm::dvec3(0.0);
    }
  }
  const ContactPlace deepest = *std::max_element(places.begin(), places.end(),
    [](const ContactPlace& p, const ContactPlace& q) { return p.depth < q.depth; });
  known_.clear();
  std::copy_if(places.begin(), places.end(), std::back_inserter(known_),
    [](const ContactPlace& place) { return !place.isCrossing; });
  reduction_.keepHull(plane, merged, places);
  if (max > 0.0)
  {
    this->weighCrossings(manifold, extent, max);
  }
  places.insert(places.end(), known_.begin(), known_.end());
  reduction_.keepHull(plane, merged, places);
  constexpr double kDeeper = 1.0 + 1e-3;
  if (deepest.depth > kDeeper * maxDepth(places))
  {
    places.push_back(deepest);
  }
  reduction_.keepSpread(plane, maxContacts, places);
  for (ContactPlace& place : places)
  {
    place.normal = place.normal == glm::dvec3(0.0) ? manifold.normal : place.normal;
  }
}

void Contacts::weighCrossings(Manifold& manifold, double extent, double max) const
{
  std::vector<ContactPlace>& places = manifold.places;
  glm::dvec3 middle(0.0);
  for (const ContactPlace& place : places)
  {
    middle += place.point / static_cast<double>(places.size());
  }
  const double inwards =
    std::max(std::min(kInwards * extent, kInwardsOfDepth * max), 0.5 * kRounded * rounding_);
  for (ContactPlace& place : places)
  {
    if (place.isCrossing)
    {
      const glm::dvec3 moved = place.point + inwards * normalised(middle - place.point);
      place.depth = this->thicknessAt(moved, manifold.normal, kOffBorder * inwards);
    }
  }
  places.erase(std::remove_if(places.begin(), places.end(),
                 [&](const ContactPlace& place)
                 { return place.isCrossing && place.depth < kShallow * max; }),
    places.end());
  for (ContactPlace& place : places)
  {
    place.isCrossing = false;
  }
}

double Contacts::thicknessAt(const glm::dvec3& x, const glm::dvec3& normal, double step) const
{
  const bool inA = solidA_.placeOf(x) == Place::Inside;
  const bool inB = solidB_.placeOf(x) == Place::Inside;
  const auto thickness = [&](const glm::dvec3& from)
  {
    const double sum = firstHit(a_, from, normal) + firstHit(b_, from, -normal);
    return std::isfinite(sum) ? sum : 0.0;
  };
  const auto thicknessIfInside = [&](const glm::dvec3& from)
  {
    return solidA_.placeOf(from) == Place::Inside && solidB_.placeOf(from) == Place::Inside
      ? thickness(from)
      : 0.0;
  };
  double found = inA && inB ? thickness(x) : 0.0;
  // On the border of the overlap rounding decides. B lies along the normal.
  if (found == 0.0 && inA)
  {
    found = thicknessIfInside(x + step * normal);
  }
  if (found == 0.0 && inB)
  {
    found = thicknessIfInside(x - step * normal);
  }
  return found;
}

glm::dvec3 Contacts::findNormal(Manifold& manifold)
{
  glm::dvec3 sum(0.0);
  double max = 0.0;
  for (const ContactPlace& place : manifold.places)
  {
    sum += place.depth * place.normal;
    max = std::max(max, place.depth);
  }
  const glm::dvec3 normal = normalised(sum);
  if (max > kTouching * rounding_ && normal != glm::dvec3(0.0))
  {
    return normal;
  }
  // What is left is rounding.
  for (ContactPlace& place : manifold.places)
  {
    place.normal = glm::dvec3(0.0);
    place.depth = 0.0;
  }
  this->addTouches(manifold);
  return touchingNormal_.find(a_, b_, manifold.pairs, kTouching * rounding_);
}

} // namespace medial

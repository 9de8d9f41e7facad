#include "proximity/contacts.h"

#include "base/exact_sign.h"
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

/// Depths below this share of the size of the meshes are those of surfaces that touch.
constexpr double kTouching = 1e-12;
/// Positions nearer than this share of a manifold's extent count as one.
constexpr double kMerged = 1e-6;
/// How far a crossing is moved into a manifold to find the overlap's thickness, as a share of its
/// extent.
constexpr double kInwards = 1e-7;
/// Crossings where the overlap is thinner than this share of its depth are none of its corners.
constexpr double kShallow = 0.01;

glm::dvec3 normalised(const glm::dvec3& vector)
{
  const double length = glm::length(vector);
  return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

/// The outward unit normal of a slot's triangle; zero for other elements.
glm::dvec3 outward(const MovingMesh& mesh, int slot)
{
  const auto& [a, b, c] = mesh.element(slot).corners;
  const glm::dvec3 normal = normalised(glm::cross(b - a, c - a));
  return mesh.weight(slot) < 0 ? -normal : normal;
}

double area(const Element& triangle)
{
  const auto& [a, b, c] = triangle.corners;
  return glm::length(glm::cross(b - a, c - a));
}

bool inOnePlane(const Element& a, const Element& b)
{
  return std::all_of(b.corners.begin(), b.corners.end(),
    [&](const glm::dvec3& x)
    { return orientation(a.corners[0], a.corners[1], a.corners[2], x) == 0; });
}

/// Whether a corner of one triangle lies in the middle of another.
bool cornerInside(const Element& corners, const Element& triangle)
{
  const glm::dvec3& a = triangle.corners[0];
  const glm::dvec3& b = triangle.corners[1];
  const glm::dvec3& c = triangle.corners[2];
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  return std::any_of(corners.corners.begin(), corners.corners.end(),
    [&](const glm::dvec3& x)
    {
      return orientation(a, b, c, x) == 0 && glm::dot(glm::cross(b - a, x - a), normal) > 0.0 &&
        glm::dot(glm::cross(c - b, x - b), normal) > 0.0 &&
        glm::dot(glm::cross(a - c, x - c), normal) > 0.0;
    });
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
  }
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    Manifold& manifold = manifolds_[split_.ofPair(i)];
    manifold.pairs.push_back(pairs[i]);
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
  const glm::dvec3 out = normalised(found.closest - found.point);
  place.normal = ofA ? -out : out;
  manifolds_[manifold].places.push_back(place);
}

void Contacts::reduce(Manifold& manifold, int maxContacts)
{
  manifold.normal = this->findNormal(manifold);
  std::vector<ContactPlace>& places = manifold.places;
  if (places.empty())
  {
    return;
  }
  const ContactPlane plane(manifold.normal);
  const double extent = extentOf(places);
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
  reduction_.keepHull(plane, kMerged * extent, places);
  if (max > 0.0)
  {
    this->weighCrossings(manifold, extent, max);
  }
  places.insert(places.end(), known_.begin(), known_.end());
  reduction_.keepHull(plane, kMerged * extent, places);
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
  for (ContactPlace& place : places)
  {
    if (place.isCrossing)
    {
      const glm::dvec3 inwards = normalised(middle - place.point);
      place.depth = this->thicknessAt(place.point + kInwards * extent * inwards, manifold.normal);
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

double Contacts::thicknessAt(const glm::dvec3& x, const glm::dvec3& normal) const
{
  if (solidA_.placeOf(x) != Place::Inside || solidB_.placeOf(x) != Place::Inside)
  {
    return 0.0;
  }
  const double thickness = firstHit(a_, x, normal) + firstHit(b_, x, -normal);
  return std::isfinite(thickness) ? thickness : 0.0;
}

glm::dvec3 Contacts::findNormal(Manifold& manifold) const
{
  glm::dvec3 sum(0.0);
  double max = 0.0;
  for (const ContactPlace& place : manifold.places)
  {
    sum += place.depth * place.normal;
    max = std::max(max, place.depth);
  }
  const double size = glm::length(a_.tree().box().size()) + glm::length(b_.tree().box().size());
  const glm::dvec3 normal = normalised(sum);
  if (max > kTouching * size && normal != glm::dvec3(0.0))
  {
    return normal;
  }
  // What is left is rounding.
  for (ContactPlace& place : manifold.places)
  {
    place.normal = glm::dvec3(0.0);
    place.depth = 0.0;
  }
  return this->touchingNormal(manifold.pairs);
}

glm::dvec3 Contacts::touchingNormal(const std::vector<SlotPair>& pairs) const
{
  glm::dvec3 sums[4]{};
  for (const SlotPair& pair : pairs)
  {
    this->addTouch(pair, sums);
  }
  for (const glm::dvec3& sum : sums)
  {
    constexpr double kLost = 1e-12;
    if (glm::length(sum) > kLost)
    {
      return glm::normalize(sum);
    }
  }
  return { 0.0, 0.0, 1.0 };
}

void Contacts::addTouch(const SlotPair& pair, glm::dvec3 (&sums)[4]) const
{
  const Element a = a_.element(pair.a);
  const Element b = b_.element(pair.b);
  const glm::dvec3 ofA = outward(a_, pair.a);
  const glm::dvec3 ofB = outward(b_, pair.b);
  sums[3] += ofA - ofB;
  if (inOnePlane(a, b))
  {
    // Solids that touch face each other; where they look the same way, one is in the other.
    sums[0] += glm::dot(ofA, ofB) < 0.0 ? std::min(area(a), area(b)) * ofA : glm::dvec3(0.0);
    return;
  }
  sums[1] -= cornerInside(a, b) ? ofB : glm::dvec3(0.0);
  sums[1] += cornerInside(b, a) ? ofA : glm::dvec3(0.0);
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec3& p = a.corners[i];
      const glm::dvec3& q = b.corners[k];
      const glm::dvec3& toP = a.corners[(i + 1) % 3];
      const glm::dvec3& toQ = b.corners[(k + 1) % 3];
      if (orientation(p, toP, q, toQ) == 0)
      {
        const glm::dvec3 across = normalised(glm::cross(toP - p, toQ - q));
        sums[2] += glm::dot(across, ofA - ofB) < 0.0 ? -across : across;
      }
    }
  }
}

} // namespace medial

#include "proximity/touching_normal.h"

#include "base/exact_sign.h"
#include "proximity/element_distance.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{

/// Sums of unit vectors shorter than this are lost in rounding.
constexpr double kLost = 1e-12;

/// Any strict order of positions will do.
int compare(const glm::dvec3& p, const glm::dvec3& q)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (p[axis] != q[axis])
    {
      return p[axis] < q[axis] ? -1 : 1;
    }
  }
  return 0;
}

int compareEnds(const glm::dvec3 (&p)[4], const glm::dvec3 (&q)[4])
{
  for (int i = 0; i < 4; ++i)
  {
    const int order = compare(p[i], q[i]);
    if (order != 0)
    {
      return order;
    }
  }
  return 0;
}

/// Whether two faces lie in one plane but for rounding, as those of a quad do.
bool areFlat(const glm::dvec3& normal, const glm::dvec3& other)
{
  constexpr double kCosine = 0.9999; // of 0.8 degrees
  return glm::dot(normal, other) > kCosine;
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

/// Whether an edge is one between triangles in one plane. The end of a surface is none.
template <typename Iterator, typename SlotOf, typename NormalOf>
bool isFlatEdge(Iterator begin, Iterator end, const SlotOf& slotOf, const NormalOf& normalOf)
{
  return std::any_of(begin, end, [&](const auto& t) { return slotOf(t) != slotOf(*begin); }) &&
    std::all_of(begin, end, [&](const auto& t) { return areFlat(normalOf(*begin), normalOf(t)); });
}

} // namespace

glm::dvec3 outwardNormal(const MovingMesh& mesh, int slot)
{
  const auto& [a, b, c] = mesh.element(slot).corners;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  if (!(length > 0.0))
  {
    return glm::dvec3(0.0);
  }
  return mesh.weight(slot) < 0 ? -normal / length : normal / length;
}

glm::dvec3 TouchingNormal::find(const MovingMesh& a, const MovingMesh& b,
  const std::vector<SlotPair>& pairs, double tolerance)
{
  cornersOfA_.clear();
  cornersOfB_.clear();
  edges_.clear();
  opposite_ = alike_ = crossing_ = meeting_ = around_ = glm::dvec3(0.0);
  for (const SlotPair& pair : pairs)
  {
    this->addPair(a, b, pair, tolerance);
  }
  this->sumEdges();
  const glm::dvec3 faces = sumOfFaces(cornersOfB_) - sumOfFaces(cornersOfA_);
  for (const glm::dvec3& sum : { opposite_, faces, crossing_, meeting_, around_, alike_ })
  {
    if (glm::length(sum) > kLost)
    {
      return glm::normalize(sum);
    }
  }
  return { 0.0, 0.0, 1.0 };
}

void TouchingNormal::addPair(const MovingMesh& a, const MovingMesh& b, const SlotPair& pair,
  double tolerance)
{
  const Element elementA = a.element(pair.a);
  const Element elementB = b.element(pair.b);
  EdgeTouch touch{ {}, false, pair, outwardNormal(a, pair.a), outwardNormal(b, pair.b) };
  around_ += touch.ofA - touch.ofB;
  if (inOnePlane(elementA, elementB))
  {
    // Solids that touch face each other; where they look the same way, one is in the other. A sheet
    // on a solid's face may look either way.
    const bool isSheetA = b.closed() && !a.closed();
    const bool isSheetB = a.closed() && !b.closed();
    const bool areOpposite = isSheetA || isSheetB || glm::dot(touch.ofA, touch.ofB) < 0.0;
    glm::dvec3& sum = areOpposite ? opposite_ : alike_;
    sum += std::min(area(elementA), area(elementB)) * (isSheetA ? -touch.ofB : touch.ofA);
    return;
  }
  const auto addCorners = [&](const Element& corners, const Element& triangle,
                            const glm::dvec3& normal, std::vector<CornerTouch>& touches)
  {
    for (const glm::dvec3& x : corners.corners)
    {
      if (normal != glm::dvec3(0.0) && isNear(triangle, x, tolerance))
      {
        touches.push_back({ x, normal });
      }
    }
  };
  addCorners(elementA, elementB, touch.ofB, cornersOfA_);
  addCorners(elementB, elementA, touch.ofA, cornersOfB_);
  this->addEdges(elementA, elementB, touch, tolerance);
}

void TouchingNormal::addEdges(const Element& a, const Element& b, const EdgeTouch& touch,
  double tolerance)
{
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EdgeTouch found = touch;
      auto& [p, toP, q, toQ] = found.ends;
      p = a.corners[i];
      toP = a.corners[(i + 1) % 3];
      q = b.corners[k];
      toQ = b.corners[(k + 1) % 3];
      const ClosePoints closest = closestPoints(edgeOf(a, i), edgeOf(b, k));
      if (closest.squared > tolerance * tolerance)
      {
        continue;
      }
      const auto isEnd = [&](const glm::dvec3& end, const glm::dvec3& x)
      { return glm::distance(end, x) <= tolerance; };
      found.inMiddles = !isEnd(p, closest.a) && !isEnd(toP, closest.a) && !isEnd(q, closest.b) &&
        !isEnd(toQ, closest.b);
      if (compare(toP, p) < 0)
      {
        std::swap(p, toP);
      }
      if (compare(toQ, q) < 0)
      {
        std::swap(q, toQ);
      }
      edges_.push_back(found);
    }
  }
}

glm::dvec3 TouchingNormal::sumOfFaces(std::vector<CornerTouch>& corners)
{
  std::sort(corners.begin(), corners.end(),
    [](const CornerTouch& p, const CornerTouch& q)
    {
      const int order = compare(p.corner, q.corner);
      return order != 0 ? order < 0 : compare(p.normal, q.normal) < 0;
    });
  glm::dvec3 sum(0.0);
  for (auto begin = corners.begin(); begin != corners.end();)
  {
    const auto end = std::find_if(begin, corners.end(),
      [&](const CornerTouch& t) { return t.corner != begin->corner; });
    if (std::all_of(begin, end,
          [&](const CornerTouch& t) { return areFlat(begin->normal, t.normal); }))
    {
      glm::dvec3 face(0.0);
      std::for_each(begin, end, [&](const CornerTouch& t) { face += t.normal; });
      sum += glm::normalize(face);
    }
    begin = end;
  }
  return sum;
}

void TouchingNormal::sumEdges()
{
  std::sort(edges_.begin(), edges_.end(),
    [](const EdgeTouch& p, const EdgeTouch& q)
    {
      const int order = compareEnds(p.ends, q.ends);
      return order != 0 ? order < 0
                        : std::pair(p.slots.a, p.slots.b) < std::pair(q.slots.a, q.slots.b);
    });
  for (auto begin = edges_.cbegin(); begin != edges_.cend();)
  {
    const auto end = std::find_if(begin, edges_.cend(),
      [&](const EdgeTouch& t) { return compareEnds(t.ends, begin->ends) != 0; });
    this->addEdgePair(begin, end);
    begin = end;
  }
}

void TouchingNormal::addEdgePair(EdgeTouches begin, EdgeTouches end)
{
  if (isFlatEdge(
        begin, end, [](const EdgeTouch& t) { return t.slots.a; },
        [](const EdgeTouch& t) { return t.ofA; }) ||
    isFlatEdge(
      begin, end, [](const EdgeTouch& t) { return t.slots.b; },
      [](const EdgeTouch& t) { return t.ofB; }))
  {
    return;
  }
  const auto& [p, toP, q, toQ] = begin->ends;
  const glm::dvec3 along = toP - p;
  const glm::dvec3 alongOther = toQ - q;
  const glm::dvec3 across = glm::cross(along, alongOther);
  const double length = glm::length(across);
  if (length <= kLost * glm::length(along) * glm::length(alongOther))
  {
    return;
  }
  glm::dvec3 outwards(0.0);
  std::for_each(begin, end, [&](const EdgeTouch& t) { outwards += t.ofA - t.ofB; });
  const double sign = glm::dot(across, outwards) < 0.0 ? -1.0 : 1.0;
  (begin->inMiddles ? crossing_ : meeting_) += sign / length * across;
}

} // namespace medial

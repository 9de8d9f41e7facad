#include "proximity/penetration.h"

#include "proximity/element_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// Points whose searches follow each other, each from what the one before it found.
constexpr std::size_t kBlock = 128;
/// Where surfaces only touch, every place may be as deep as any other, and no bound tells. Parts of
/// machines with thousands of faces need up to 29,000.
constexpr int kMaxRefinements = 50000;
/// Pairs of crossings of a triangle between which the depth is tried first.
constexpr int kMaxSeeds = 12;

double limitOf(double depth, double relative, double absolute)
{
  return std::max(depth * (1.0 + relative), depth + absolute);
}

} // namespace

void Penetration::find(const std::vector<int>& cut, bool depths)
{
  enclosed_.find(mesh_, solid_, other_.tree().box(), cut);
  closest_.clear();
  if (!depths)
  {
    return;
  }
  const auto& points = enclosed_.points();
  closest_.resize(points.size());
  tbb::parallel_for(std::size_t{ 0 }, (points.size() + kBlock - 1) / kBlock,
    [&](std::size_t block)
    {
      const std::size_t begin = block * kBlock;
      const std::size_t end = std::min(points.size(), begin + kBlock);
      for (std::size_t i = begin; i < end; i += kDoubleLanes)
      {
        this->findClosest(i, std::min(end, i + kDoubleLanes), begin);
      }
    });
}

void Penetration::findClosest(std::size_t begin, std::size_t end, std::size_t known)
{
  const auto position = [&](std::size_t i) { return mesh_.points()[enclosed_.points()[i].point]; };
  // The first point has nothing to start from.
  const int before =
    begin > known ? closest_[begin - 1].slot : closestElement(other_, position(begin)).slot;
  std::array<glm::dvec3, kDoubleLanes> positions{};
  for (std::size_t i = begin; i < end; ++i)
  {
    const int from = enclosed_.points()[i].from;
    const bool isKnown = from >= static_cast<int>(known) && from < static_cast<int>(begin);
    closest_[i].slot = isKnown ? closest_[from].slot : before;
    positions[i - begin] = position(i);
  }
  closestElements(other_, positions.data(), static_cast<int>(end - begin), &closest_[begin]);
}

double Penetration::depthOf(std::size_t enclosed) const
{
  return std::sqrt(closest_[enclosed].squared);
}

DeepPlace Penetration::placeOf(std::size_t enclosed) const
{
  const int point = enclosed_.points()[enclosed].point;
  const ClosestElement& closest = closest_[enclosed];
  return { &mesh_, this->depthOf(enclosed), mesh_.points()[point], closest.point,
    *mesh_.pointSlots().begin(point), closest.slot };
}

DeepPlace Penetration::deepestPoint() const
{
  const auto deepest = std::max_element(closest_.begin(), closest_.end(),
    [](const ClosestElement& p, const ClosestElement& q) { return p.squared < q.squared; });
  return deepest == closest_.end() ? DeepPlace{}
                                   : this->placeOf(std::distance(closest_.begin(), deepest));
}

DeepPlace Penetration::deepest(const std::vector<int>& cut, const std::vector<CutPlace>& crossings,
  const DeepPlace& known, double relative, double absolute)
{
  DeepPlace best = known;
  this->trySeeds(crossings, best);
  pieces_.clear();
  middles_.clear();
  const double limit = limitOf(best.depth, relative, absolute);
  for (const int slot : cut)
  {
    this->addPiece(this->wholeTriangle(slot), limit);
  }
  for (const EnclosedPoints::Enclosed& enclosed : enclosed_.points())
  {
    const IncidenceLists& slots = mesh_.pointSlots();
    for (const int* slot = slots.begin(enclosed.point); slot != slots.end(enclosed.point); ++slot)
    {
      // A triangle comes up with every point that is inside.
      if (!enclosed_.isCut(*slot) && this->firstInside(*slot) == enclosed.point)
      {
        this->addPiece(this->wholeTriangle(*slot), limit);
      }
    }
  }
  for (int i = 0; i < kMaxRefinements && !pieces_.empty(); ++i)
  {
    const auto less = [](const Piece& p, const Piece& q) { return p.max < q.max; };
    std::pop_heap(pieces_.begin(), pieces_.end(), less);
    const Piece piece = pieces_.back();
    pieces_.pop_back();
    if (piece.max <= limitOf(best.depth, relative, absolute))
    {
      break;
    }
    this->refine(piece, best, relative, absolute);
  }
  atMost_ = limitOf(best.depth, relative, absolute);
  if (!pieces_.empty())
  {
    atMost_ = std::max(atMost_, pieces_.front().max);
  }
  return best;
}

void Penetration::trySeeds(const std::vector<CutPlace>& crossings, DeepPlace& best) const
{
  // Of triangles much larger than the depth only: the middles of others are as good.
  constexpr double kLarge = 3.0;
  const std::size_t count = crossings.size();
  for (std::size_t begin = 0; begin < count;)
  {
    const int slot = crossings[begin].slot;
    std::size_t end = begin;
    while (end < count && crossings[end].slot == slot)
    {
      ++end;
    }
    int tried = this->wholeTriangle(slot).max > kLarge * best.depth ? 0 : kMaxSeeds;
    for (std::size_t apart = 1; apart < end - begin && tried < kMaxSeeds; ++apart)
    {
      for (std::size_t i = begin; i + apart < end && tried < kMaxSeeds; ++i, ++tried)
      {
        this->tryPlace(0.5 * (crossings[i].point + crossings[i + apart].point), slot, best);
      }
    }
    begin = end;
  }
}

void Penetration::tryPlace(const glm::dvec3& x, int slot, DeepPlace& best) const
{
  const int hint = best.mesh == &mesh_ ? best.otherSlot : -1;
  const ClosestElement closest = closestElement(other_, x, hint);
  const double depth = std::sqrt(closest.squared);
  if (depth > best.depth && solid_.placeOf(x) == Place::Inside)
  {
    best = { &mesh_, depth, x, closest.point, slot, closest.slot };
  }
}

int Penetration::firstInside(int slot) const
{
  const glm::ivec3& corners = mesh_.corners(slot);
  return enclosed_.isInside(corners[0])
    ? corners[0]
    : (enclosed_.isInside(corners[1]) ? corners[1] : corners[2]);
}

Penetration::Piece Penetration::wholeTriangle(int slot) const
{
  Piece piece{ mesh_.element(slot).corners, 0.0, slot, -1 };
  double longest = 0.0;
  double max = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& corner = piece.corners[i];
    const double reach = std::max(glm::distance(corner, piece.corners[(i + 1) % 3]),
      glm::distance(corner, piece.corners[(i + 2) % 3]));
    longest = std::max(longest, reach);
    const int point = mesh_.corners(slot)[i];
    if (enclosed_.isInside(point))
    {
      const int index = enclosed_.indexOf(point);
      const double bound = this->depthOf(index) + reach;
      piece.hint = bound < max ? closest_[index].slot : piece.hint;
      max = std::min(max, bound);
    }
  }
  // A place inside a cut triangle is no farther from the other surface than from the cut.
  piece.max = enclosed_.isCut(slot) ? std::min(max, longest) : max;
  return piece;
}

void Penetration::addPiece(const Piece& piece, double limit)
{
  Box box;
  for (const glm::dvec3& corner : piece.corners)
  {
    box.add(corner);
  }
  // No solid is outside the box of its surface.
  if (piece.max > limit && box.overlaps(other_.tree().box()))
  {
    pieces_.push_back(piece);
    std::push_heap(pieces_.begin(), pieces_.end(),
      [](const Piece& p, const Piece& q) { return p.max < q.max; });
  }
}

void Penetration::refine(const Piece& piece, DeepPlace& best, double relative, double absolute)
{
  const glm::dvec3 middle = piece.centre();
  const ClosestElement closest =
    piece.middle >= 0 ? middles_[piece.middle] : closestElement(other_, middle, piece.hint);
  const double depth = std::sqrt(closest.squared);
  const bool inside = !this->isMixed(piece.slot) || solid_.placeOf(middle) == Place::Inside;
  if (inside && depth > best.depth)
  {
    best = { &mesh_, depth, middle, closest.point, piece.slot, closest.slot };
  }
  // The distance to a convex element is largest at a corner; along a line to a place beyond the
  // surface the depth begins where the line comes in.
  double toElement = 0.0;
  double radius = 0.0;
  for (const glm::dvec3& corner : piece.corners)
  {
    toElement = std::max(toElement,
      glm::distance(corner, closestPoint(other_.element(closest.slot), corner)));
    radius = std::max(radius, glm::distance(corner, middle));
  }
  // Through a hole a line comes in without passing the surface.
  const bool beyond = !inside && !solid_.open();
  const double max = std::min({ piece.max, toElement, beyond ? radius - depth : depth + radius });
  this->addParts(piece, max, closest.slot, limitOf(best.depth, relative, absolute));
}

void Penetration::addParts(const Piece& piece, double max, int hint, double limit)
{
  if (max <= limit)
  {
    return;
  }
  const auto& [a, b, c] = piece.corners;
  const glm::dvec3 ab = 0.5 * (a + b);
  const glm::dvec3 bc = 0.5 * (b + c);
  const glm::dvec3 ca = 0.5 * (c + a);
  const std::array<std::array<glm::dvec3, 3>, 4> parts = { { { a, ab, ca }, { ab, b, bc },
    { ca, bc, c }, { ab, bc, ca } } };
  // Most parts come up, and their middles are searched for at once.
  const int first = static_cast<int>(middles_.size());
  std::array<glm::dvec3, 4> centres;
  for (int i = 0; i < 4; ++i)
  {
    const Piece part{ parts[i], max, piece.slot, hint, first + i };
    centres[i] = part.centre();
    middles_.emplace_back();
    middles_.back().slot = hint;
    this->addPiece(part, limit);
  }
  closestElements(other_, centres.data(), 4, &middles_[first]);
}

} // namespace medial

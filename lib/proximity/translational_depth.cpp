#include "proximity/translational_depth.h"

#include "base/longest_axis.h"
#include "proximity/closest_element.h"
#include "proximity/intersections.h"
#include "proximity/last_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

/// By how much a translation is lengthened so that the surfaces do not touch, as a share of the
/// size of the meshes.
constexpr double kApart = 1e-11;
/// No exit is lengthened by more than this share of the size.
constexpr double kTooFar = 1e-3;
/// Lower bounds are lowered by this share of the size against rounding and what isConvex() allows.
constexpr double kCertain = 1e-9;
/// Turns towards the normal of the last contact.
constexpr int kMaxTurns = 4;
/// Bounds as near to each other as this are good enough.
constexpr double kClose = 0.99;
/// Rounding of distances, as a share.
constexpr double kDistanceRounding = 1e-9;
/// Positions that may be looked at for the largest balls.
constexpr int kMaxCentres = 96;

/// The size of both meshes, or what coordinates are rounded to where they are points; never 0.
double sizeOf(const MovingMesh& a, const MovingMesh& b)
{
  constexpr double kRounding = 1e-4;
  double size = std::numeric_limits<double>::min();
  for (const MovingMesh* mesh : { &a, &b })
  {
    const Box& box = mesh->tree().box();
    const glm::dvec3 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
    size += glm::length(box.size()) + kRounding * glm::length(farthest);
  }
  return size;
}

} // namespace

TranslationalDepth::Exit TranslationalDepth::findExit(const std::vector<glm::dvec3>& directions,
  double& hullLower)
{
  const HullDepth hulls = minkowski_.find();
  Exit best = this->boxExit();
  if (hulls.upper < best.length && hulls.direction != glm::dvec3(0.0))
  {
    best = { hulls.direction, hulls.upper, glm::dvec3(0.0) };
  }
  const bool convex = isConvex(a_) && isConvex(b_);
  hullLower = convex ? hulls.lower : 0.0;
  if (!convex)
  {
    this->tryDirection(best.direction, best);
    for (const glm::dvec3& direction : directions)
    {
      this->tryDirection(direction, best);
    }
    this->turn(best);
  }
  return best;
}

void TranslationalDepth::turn(Exit& best) const
{
  for (int i = 0; i < kMaxTurns && best.normal != glm::dvec3(0.0); ++i)
  {
    const glm::dvec3 last = best.normal;
    this->tryDirection(last, best);
    if (best.normal == last)
    {
      this->tryDirection(glm::normalize(best.direction + last), best);
      return;
    }
  }
}

DepthBounds TranslationalDepth::find(const DeepPlace& deepest,
  const std::vector<glm::dvec3>& directions, glm::dvec3& translation)
{
  double hullLower = 0.0;
  const Exit found = this->findExit(directions, hullLower);
  const double size = sizeOf(a_, b_);
  double lower = hullLower;
  // Points leave an open solid through its holes, so no ball holds them.
  if (hullLower == 0.0 && !solidA_.open() && !solidB_.open())
  {
    lower = this->commonBalls(deepest, kClose * found.length);
  }
  double upper = 0.0;
  if (!this->lengthen(found, size, upper, translation))
  {
    this->lengthen(this->boxExit(), size, upper, translation);
  }
  return { std::max(0.0, lower - kCertain * size), upper };
}

bool TranslationalDepth::lengthen(const Exit& exit, double size, double& length,
  glm::dvec3& translation) const
{
  for (double margin = kApart; margin < kTooFar; margin *= 8.0)
  {
    length = exit.length + margin * size;
    translation = length * exit.direction;
    if (this->separates(translation))
    {
      return true;
    }
  }
  return false;
}

TranslationalDepth::Exit TranslationalDepth::boxExit() const
{
  const Box& boxA = a_.tree().box();
  const Box& boxB = b_.tree().box();
  Exit best;
  best.length = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sense : { 1.0, -1.0 })
    {
      const double length =
        sense > 0.0 ? boxB.max[axis] - boxA.min[axis] : boxA.max[axis] - boxB.min[axis];
      if (length < best.length)
      {
        best.length = length;
        best.direction = glm::dvec3(0.0);
        best.direction[axis] = sense;
      }
    }
  }
  return best;
}

void TranslationalDepth::tryDirection(const glm::dvec3& direction, Exit& best) const
{
  const LastContact last = lastContact(a_, b_, direction, best.length);
  if (last.distance < best.length ||
    (last.distance == best.length && best.normal == glm::dvec3(0.0)))
  {
    best = { direction, last.distance, last.normal };
  }
}

std::array<TranslationalDepth::Part, 2> TranslationalDepth::halve(const Part& part) const
{
  // Along the longest side, so that flat overlaps have cubes, too.
  const glm::dvec3 size = part.box.size();
  const int axis = longestAxis(size);
  std::array<Part, 2> halves{ part, part };
  for (int i = 0; i < 2; ++i)
  {
    Box& half = halves[i].box;
    half.min[axis] += 0.5 * i * size[axis];
    half.max[axis] = half.min[axis] + 0.5 * size[axis];
  }
  const double moved = 0.25 * size[axis];
  findNearness(a_, solidA_, halves, moved, &Part::toA);
  findNearness(b_, solidB_, halves, moved, &Part::toB);
  for (Part& half : halves)
  {
    // Either depth grows by no more than one goes.
    half.max = std::min(part.max, half.sumOfDepths() + glm::length(half.box.size()));
  }
  return halves;
}

void TranslationalDepth::findNearness(const MovingMesh& mesh, const SolidQuery& solid,
  std::array<Part, 2>& halves, double moved, Nearness Part::*nearness)
{
  const Nearness before = halves[0].*nearness;
  const std::array<glm::dvec3, 2> centres = { halves[0].centre(), halves[1].centre() };
  std::array<ClosestElement, 2> closest;
  closest[0].slot = closest[1].slot = before.slot;
  closestElements(mesh, centres.data(), 2, closest.data());
  // Nearer to the last centre than to the surface, they are on its side.
  const bool sameSide = moved < (1.0 - kDistanceRounding) * std::abs(before.depth);
  for (int i = 0; i < 2; ++i)
  {
    const bool inside = sameSide ? before.depth > 0.0 : solid.placeOf(centres[i]) == Place::Inside;
    const double distance = std::sqrt(closest[i].squared);
    halves[i].*nearness = { inside ? distance : -distance, closest[i].slot };
  }
}

double TranslationalDepth::commonBalls(const DeepPlace& deepest, double enough)
{
  // A place of one surface has a ball of radius 0 in its own solid.
  double best = deepest.depth;
  Box common;
  common.min = glm::max(a_.tree().box().min, b_.tree().box().min);
  common.max = glm::min(a_.tree().box().max, b_.tree().box().max);
  const auto less = [](const Part& p, const Part& q) { return p.max < q.max; };
  parts_.clear();
  parts_.push_back({ common, std::numeric_limits<double>::infinity(), {}, {} });
  for (int looked = 0; looked < kMaxCentres && !parts_.empty() && best < enough;)
  {
    std::pop_heap(parts_.begin(), parts_.end(), less);
    const Part part = parts_.back();
    parts_.pop_back();
    if (part.max <= best)
    {
      break;
    }
    for (const Part& half : this->halve(part))
    {
      const bool inBoth = half.toA.depth > 0.0 && half.toB.depth > 0.0;
      best = inBoth ? std::max(best, half.sumOfDepths()) : best;
      if (half.max > best)
      {
        parts_.push_back(half);
        std::push_heap(parts_.begin(), parts_.end(), less);
      }
      ++looked;
    }
  }
  return best;
}

bool TranslationalDepth::separates(const glm::dvec3& translation) const
{
  if (intersect(a_, translation, b_))
  {
    return false;
  }
  const auto noneInside =
    [](const MovingMesh& mesh, const SolidQuery& solid, const glm::dvec3& offset)
  {
    const auto outside = [&](int point)
    { return solid.placeOf(mesh.points()[point] + offset) == Place::Outside; };
    const auto& points = solid.open() ? mesh.usedPoints() : mesh.componentPoints();
    return std::all_of(points.begin(), points.end(), outside);
  };
  return noneInside(a_, solidB_, translation) && noneInside(b_, solidA_, -translation);
}

} // namespace medial

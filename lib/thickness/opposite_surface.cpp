#include "thickness/opposite_surface.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Share of the diagonal within which a face is part of the surface that the ray starts on.
constexpr double kTooNear = 1e-6;
/// Cosine of the angle between a ray and a face's normal. Below the first the ray runs along the
/// face; above the second and right at the start, the face is that of a body on which the other one
/// stands.
constexpr double kAlong = 1e-3;
constexpr double kAcross = 0.99999;
/// Borders that lie opposite each other meet in spite of rounding: this share of a triangle outside
/// it counts as inside.
constexpr double kMargin = 1e-6;
/// Boxes are widened by this share of the diagonal: a triangle and what counts as inside lie
/// within, so which faces are found does not depend on the boxes.
constexpr double kWidened = 3.0 * kMargin;

} // namespace

OppositeSurface::OppositeSurface(const SiteSet& sites, double diagonal)
  : sites_(sites)
  , diagonal_(diagonal)
{
  if (!sites.faces().empty())
  {
    tree_.build(sites.points(), sites.faces());
  }
}

HalfLine OppositeSurface::rayFrom(const glm::dvec3& start, const glm::dvec3& direction,
  double diagonal)
{
  return HalfLine(start, direction, kWidened * diagonal);
}

std::optional<RayEnd> OppositeSurface::find(const HalfLine& ray, double sign, const RayStart& start,
  double limit) const
{
  RayEnd end;
  const auto look = [&](int face)
  {
    if (sites_.faceNormal(face) == glm::dvec3(0.0))
    {
      return; // without area: what is beside it counts
    }
    const glm::ivec3& corners = sites_.faces()[face];
    const double distance = ray.distanceTo(sites_.points()[corners[0]], sites_.points()[corners[1]],
      sites_.points()[corners[2]], kMargin);
    const double cosine = sign * glm::dot(sites_.faceNormal(face), ray.direction());
    const bool isAtStart = distance <= kTooNear * diagonal_ && (cosine <= 0.0 || cosine >= kAcross);
    const bool better = distance < end.distance || (distance == end.distance && face < end.face);
    if (better && std::isfinite(distance) && std::abs(cosine) >= kAlong && !isAtStart &&
      !start.isOn(face, corners))
    {
      end.distance = std::max(distance, 0.0);
      end.face = face;
    }
  };
  if (tree_.nodes().empty())
  {
    return std::nullopt;
  }
  tree_.visitLeaves([&](const Box& box) { return ray.meets(box, std::min(end.distance, limit)); },
    [&](const BoxTree::Node& leaf)
    {
      for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
      {
        look(tree_.elements()[slot]);
      }
    });
  if (end.face < 0)
  {
    return std::nullopt;
  }
  end.normal = sites_.faceNormal(end.face);
  return end;
}

} // namespace medial

#pragma once

#include "base/box_tree.h"
#include "base/half_line.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>

namespace medial
{

/// Finds where a ray from the surface reaches the opposite surface.
class OppositeSurface
{
public:
  struct Hit
  {
    double distance = std::numeric_limits<double>::infinity();
    int face = -1;
  };

  /// @param sites must outlive this. Uses the threads of the current arena.
  /// @param diagonal of the bounds, local units.
  OppositeSurface(const SiteSet& sites, double diagonal);

  /// Returns the first face that the ray meets; nothing if there is none. A face that the ray
  /// enters the solid through is passed over right at the start: there it is another part of the
  /// surface that the ray starts on, by rounding.
  /// @param sign 1 for a ray in the solid, -1 for one outside.
  /// @param skips whether a face is one of those that the ray starts on.
  template <typename Skips>
  std::optional<Hit> find(const HalfLine& ray, double sign, const Skips& skips) const;

private:
  const SiteSet& sites_;
  double tooNear_;
  BoxTree tree_;
};

template <typename Skips>
std::optional<OppositeSurface::Hit> OppositeSurface::find(const HalfLine& ray, double sign,
  const Skips& skips) const
{
  // Borders that lie opposite each other meet in spite of rounding.
  constexpr double kMargin = 1e-6;
  Hit hit;
  const auto look = [&](int face)
  {
    const glm::ivec3& corners = sites_.faces()[face];
    const double distance = ray.distanceTo(sites_.points()[corners[0]], sites_.points()[corners[1]],
      sites_.points()[corners[2]], kMargin);
    const bool leaves = sign * glm::dot(sites_.faceNormal(face), ray.direction()) > 0.0;
    // Of equal distances the lowest face counts, whatever the order of the tree.
    const bool better = distance < hit.distance || (distance == hit.distance && face < hit.face);
    if (better && std::isfinite(distance) && (leaves || distance > tooNear_) && !skips(face))
    {
      hit = { distance, face };
    }
  };
  tree_.visitLeaves([&](const Box& box) { return ray.meets(box, hit.distance); },
    [&](const BoxTree::Node& leaf)
    {
      for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
      {
        look(tree_.elements()[slot]);
      }
    });
  return hit.face >= 0 ? std::optional(hit) : std::nullopt;
}

} // namespace medial

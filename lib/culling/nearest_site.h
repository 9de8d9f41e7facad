#pragma once

#include "culling/site_group.h"
#include "sites/closest_point.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <limits>

namespace medial
{

/// Returns a bound of the rounding of distances from the elements of a group. It is much smaller
/// than that of positions in the grid, so that few elements are left for double precision.
/// @param farthest how far the position and the elements are from what they are relative to, added.
MEDIAL_INLINE float roundingWithin(float farthest)
{
  constexpr float kRounding = 16.0f * std::numeric_limits<float>::epsilon();
  return kRounding * farthest;
}

/// The same.
/// @param offset of the position from the group's origin.
/// @param extent of the group.
MEDIAL_INLINE float roundingFrom(const glm::vec3& offset, float extent)
{
  return roundingWithin(glm::length(offset) + extent);
}

/// The closest of the surface points that have been offered, in double precision; of several at
/// the same distance that of the lowest site.
class NearestSite
{
public:
  /// @param limit points at this distance from x or beyond do not count.
  NearestSite(const SiteSet& sites, const glm::dvec3& x,
    double limit = std::numeric_limits<double>::infinity());
  /// @param known of a site that counts from the start.
  /// @param other site that is no nearer, nor as near and lower; -1 for none.
  NearestSite(const SiteSet& sites, const glm::dvec3& x, const SitePoint& known, int other);

  /// Finds the sites of a group that can be closest to a position.
  /// @param x relative to the group's origin.
  /// @param distance sites farther away do not count.
  /// @param slack by how much their Voronoi regions are widened, besides the rounding.
  /// @param parts set to the sites, as bits of SitePart, for the elements of the result.
  /// @return the elements that own such sites, as bits.
  static unsigned sitesNear(const SiteGroup& group, const glm::vec3& x, float distance, float slack,
    SiteGroup::IntLanes& parts);

  /// Offers sites of a group, as sitesNear() finds them.
  void offer(const SiteGroup& group, unsigned lanes, const SiteGroup::IntLanes& parts);

  /// Offers one site.
  void offer(int site)
  {
    if (site != known_ && site != other_)
    {
      this->compare(site);
    }
  }

  /// Its site is -1 if no point counts.
  const SitePoint& closest() const { return closest_; }
  /// That of the closest point, or the limit.
  double distance() const { return distance_; }

private:
  void compare(int site);

  const SiteSet& sites_;
  glm::dvec3 x_;
  SitePoint closest_;
  double distance_;
  int known_ = -1;
  int other_ = -1;
};

} // namespace medial

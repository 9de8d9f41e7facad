#pragma once

#include "sites/grid_frame.h"
#include "sites/site_set.h"
#include "thinning/voxel_solid.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Tells apart bodies that touch or are less than a voxel from each other: closed voxels would join
/// them. A body is what a connected part of the surface encloses if it faces outwards.
/// Parts that face inwards are walls of cavities and belong to the bodies next to them.
/// Bodies that overlap by more than a voxel are one.
class SolidBodies
{
public:
  /// @param directions per triangle: 1 if it faces outwards as it is, or -1.
  /// @param size of the grid.
  /// @param depth of all bodies; interior.
  SolidBodies(const SiteSet& sites, const std::vector<std::int8_t>& directions,
    const GridFrame& frame, const glm::ivec3& size, const std::int32_t* closestSites,
    const DepthField& depth);

  /// Number of colours. Bodies that only seem to touch have different colours. A mesh of one body,
  /// or of bodies that stay apart, needs one colour.
  int colours() const { return colours_; }
  /// Colour of each site's body.
  const std::vector<int>& siteColours() const { return siteColours_; }

private:
  int colours_ = 1;
  std::vector<int> siteColours_;
};

} // namespace medial

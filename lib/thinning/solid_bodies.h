#pragma once

#include "sites/grid_frame.h"
#include "sites/site_set.h"
#include "thinning/voxel_solid.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// Tells bodies apart that are nearer to each other than a voxel, or touch: closed voxels would
/// join them. A body is what a connected part of the surface encloses that is oriented like the
/// whole; parts oriented the other way are walls of cavities and belong to the bodies that they are
/// next to, and so do bodies to each other that overlap by more than a voxel.
class SolidBodies
{
public:
  /// @param size of the grid.
  /// @param depth of all bodies; interior.
  SolidBodies(const SiteSet& sites, const GridFrame& frame, const glm::ivec3& size,
    const std::int32_t* closestSites, const DepthField& depth);

  /// Bodies are coloured so that those which only seem to touch differ; a mesh of one body, or of
  /// bodies that stay apart, needs one colour.
  int colours() const { return colours_; }
  /// Colour of each site's body.
  const std::vector<int>& siteColours() const { return siteColours_; }

private:
  int colours_ = 1;
  std::vector<int> siteColours_;
};

} // namespace medial

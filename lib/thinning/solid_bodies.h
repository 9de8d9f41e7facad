#pragma once

#include "medial/grid.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"
#include "thinning/voxel_solid.h"

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace medial
{

/// Connected parts of a surface.
struct SurfaceParts
{
  std::vector<int> ofSite;
  std::vector<std::uint8_t> areBodies; ///< for each part not 0 if it faces outwards

  int count() const { return static_cast<int>(areBodies.size()); }
};

/// Returns what a triangle adds to six times the volume that a part encloses.
/// @param direction 1 if it faces outwards as it is, or -1.
inline double enclosedBy(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
  int direction)
{
  return direction * glm::dot(a, glm::cross(b, c));
}

/// Which parts are next to each other in the solid, and which only seem to be.
struct PartPairs
{
  using Pair = std::pair<int, int>; ///< the lower part first

  std::set<Pair> joined;
  std::set<Pair> apart;
};

/// A field where parts are looked at.
struct FieldOfParts
{
  const SiteSet& sites;
  const std::vector<std::int8_t>& directions; ///< as SolidBodies
  const GridFrame& frame;
  Extent part;     ///< of the grid, whose points the arrays have
  glm::ivec3 grid; ///< size of the whole
  const std::int32_t* closestSites;
  const DepthField& depth; ///< of all bodies; interior
};

/// Returns the pairs of parts that neighbours in a field are closest to.
PartPairs pairsOfParts(const FieldOfParts& field, const SurfaceParts& parts);

/// Gives parts colours: those next to each other the same one, those that only seem to be others.
std::vector<int> coloursOfParts(int parts, const PartPairs& pairs);

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

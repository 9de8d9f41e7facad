#pragma once

#include "medial/grid.h"
#include "ranks/field/rank_field.h"
#include "ranks/surface/shared_parts.h"
#include "thinning/solid_bodies.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// The connected parts of a surface in pieces, as SolidBodies has them in one process: numbered in
/// the order of their first points. All ranks know how many there are and which face outwards; the
/// ranks that points fall to know of which part they are.
class SharedBodies
{
public:
  /// Every rank calls it. The first rank joins the parts that go on from share to share.
  /// @param field whose surface still has its triangles, and a sign; must outlive this.
  SharedBodies(Communicator& communicator, const RankField& field);

  int parts() const { return static_cast<int>(areBodies_.size()); }

  /// Gives bodies their colours, as SolidBodies. Every rank calls it.
  /// @param part of the grid, where the closest sites are known and here; may be empty. The parts
  ///   of all ranks have all grid cells.
  /// @param grid size of the whole.
  void findColours(Communicator& communicator, const Extent& part, const glm::ivec3& grid,
    const std::int32_t* closestSites, const DepthField& depth);
  int colours() const { return colours_; }
  /// Returns the colours of all sites that are here. Every rank calls it.
  std::vector<int> siteColours(Communicator& communicator) const;

private:
  void measure(Communicator& communicator, const std::vector<PartLabel>& labels);
  std::vector<std::int8_t> directionsOf(Communicator& communicator,
    const std::vector<int>& faces) const;
  /// Returns the parts of all sites that are here. Every rank calls it.
  std::vector<int> partsOfSites(Communicator& communicator) const;

  const RankField& field_;
  std::vector<std::uint8_t> areBodies_;
  /// Of the points that fall to this rank, ascending, with the numbers of their parts.
  std::vector<PartLabel> labels_;
  int colours_ = 1;
  std::vector<int> coloursOfParts_; ///< once they are known
};

} // namespace medial

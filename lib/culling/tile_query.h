#pragma once

#include "medial/culling/candidate_filter.h"
#include "medial/culling/candidate_tiles.h"
#include "medial/sites/closest_point.h"

#include <glm/glm.hpp>

#include <limits>
#include <vector>

namespace medial
{

/// Exact closest surface points, in double precision, at arbitrary positions: all candidates of the
/// tile around the position are tried.
class TileQuery
{
public:
  /// @param tileSize of the tiles that will be added: CandidateHierarchy::leafSize().
  TileQuery(const SiteSet& sites, const CandidateFilter& filter, const GridFrame& frame,
    const Extent& extent, const glm::ivec3& tileSize);

  /// Adds the tiles of one block. They must cover the hull of what is asked for later.
  void add(CandidateTiles tiles);

  /// @param x frame coordinates, inside the hull of a tile that was added.
  /// @param knownDistance of some surface point from x, to start from; the nearer, the faster.
  SitePoint closest(const glm::dvec3& x,
    double knownDistance = std::numeric_limits<double>::max()) const;

private:
  struct Candidates
  {
    const int* begin = nullptr;
    const int* end = nullptr;
  };

  std::size_t tileIndex(const glm::ivec3& gridPoint) const;

  const SiteSet& sites_;
  const CandidateFilter& filter_;
  GridFrame frame_;
  Extent extent_;
  glm::ivec3 tileSize_;
  glm::ivec3 tileCounts_;
  std::vector<CandidateTiles> blocks_;
  std::vector<Candidates> tiles_; ///< x fastest
};

} // namespace medial

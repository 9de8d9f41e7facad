#pragma once

#include "culling/candidate_filter.h"
#include "culling/candidate_tiles.h"
#include "sites/closest_point.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Finds exact closest surface points, in double precision, at any position: it tries all
/// candidates of the tile around the position.
class TileQuery
{
public:
  /// @param extent where the queries will be, of a hierarchy or some of its layers.
  /// @throws Error OutOfMemory.
  TileQuery(const SiteSet& sites, const CandidateFilter& filter, const GridFrame& frame,
    const Extent& extent);

  /// Adds the tiles of one block. Together they must cover the positions of later queries.
  void add(CandidateTiles tiles);

  /// Returns the closest surface point.
  /// @param x local coordinates, inside the hull of a tile that was added.
  /// @param known start of the search: the closest point of some site to x. The nearer it is, the
  ///   faster the search. It is returned if no other point is nearer. A site of -1 means none.
  SitePoint closest(const glm::dvec3& x, const SitePoint& known = {}) const;

  /// A position with a known point, which closest() replaces by the closest one.
  struct Question
  {
    glm::dvec3 x;
    SitePoint closest;
  };
  /// The same for many positions; those in one tile are answered together.
  void closest(std::vector<Question>& questions) const;

private:
  struct Candidates
  {
    const int* begin = nullptr;
    const int* end = nullptr;
  };

  std::size_t tileIndex(const glm::ivec3& gridPoint) const;
  std::size_t tileAround(const glm::dvec3& x) const;
  /// @param count in [1, PointLanes::kMax].
  void closestInTile(const Candidates& tile, Question* const* questions, int count,
    std::vector<NearSite>& scratch) const;

  const SiteSet& sites_;
  const CandidateFilter& filter_;
  GridFrame frame_;
  Extent extent_;
  glm::ivec3 tileCounts_;
  std::vector<CandidateTiles> blocks_;
  std::vector<Candidates> tiles_; ///< x fastest
};

} // namespace medial

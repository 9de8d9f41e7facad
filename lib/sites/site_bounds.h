#pragma once

#include "base/lazy_table.h"
#include "medial/mesh_connectivity.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// The closed half-space dot(normal, x) <= offset, stored as (normal, offset) with a unit normal.
using HalfSpace = glm::vec4;

/// Half-spaces that contain the Voronoi regions of sites, made where they are needed: a mesh much
/// finer than the grid needs hardly any.
///
/// A point whose closest surface point lies inside a site is in all half-spaces of the site. Each
/// of them says "nearer to this site than to the rest of one incident element". This holds for
/// convex, concave, saddle, boundary and non-manifold elements alike; section 4 of the paper has
/// looser bounds for some of them.
class SiteBounds
{
public:
  /// @param sites, connectivity must outlive this.
  SiteBounds(const SiteSet& sites, const MeshConnectivity& connectivity);

  /// Makes the half-spaces of a site. Several threads may call this at once.
  void prepare(int site) const;

  /// Frees the memory of all half-spaces, until they are prepared again.
  void forget() { halfSpaces_.forget(); }

  /// Half-spaces of a site that has been prepared. A face has one at each of its three edges, then
  /// two across the ends of its longest edge. An edge has two across its ends, then one for each of
  /// its faces. A vertex has one for each of its edges.
  const HalfSpace* begin(int site) const { return &halfSpaces_[offsets_[site]]; }
  const HalfSpace* end(int site) const { return &halfSpaces_[offsets_[site + 1]]; }

private:
  int countOf(int site) const;
  void setFace(int face, HalfSpace* out) const;
  void setEdge(int edge, HalfSpace* out) const;
  void setVertex(int vertex, HalfSpace* out) const;

  const SiteSet& sites_;
  const MeshConnectivity& connectivity_;
  std::vector<std::uint32_t> offsets_; ///< of sites, one more; kMaxCorners keeps them below 2^32
  LazyTable<HalfSpace> halfSpaces_;
};

} // namespace medial

#pragma once

#include "base/lazy_table.h"
#include "culling/group_list.h"
#include "culling/group_tree.h"
#include "sites/grid_frame.h"
#include "sites/site_bounds.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Decides which sites can be closest to some point of a box. The filter is conservative: it never
/// drops a site that is, so it can change the time but not the result.
class CandidateFilter
{
public:
  /// Number of boxes that are filtered at once.
  static constexpr int kMaxBoxes = 8;

  /// @param sites, connectivity must outlive this.
  CandidateFilter(const SiteSet& sites, const MeshConnectivity& connectivity,
    const GridFrame& frame);
  /// @param tree over the sites.
  CandidateFilter(const SiteSet& sites, const MeshConnectivity& connectivity, GroupTree tree);

  /// Half-spaces of all sites that have been listed.
  const SiteBounds& bounds() const { return bounds_; }

  /// Frees the memory of what has been made for the tests, which make it again.
  void forget()
  {
    bounds_.forget();
    facePlanes_.forget();
    edgeLines_.forget();
  }

  /// The elements of the mesh.
  const GroupTree& tree() const { return tree_; }

  /// Working memory of one thread.
  struct Scratch
  {
    std::vector<int> sites;                       ///< of the groups
    std::array<std::vector<int>, kMaxBoxes> near; ///< survivors of the cheap tests
    std::vector<std::array<float, 8>> corners;    ///< squared distances to the corners of boxes
  };

  /// Lists the sites, ascending, that can be closest somewhere in each of some neighbouring boxes.
  /// Those of the groups stay that pass four tests:
  /// - the Voronoi region of the site, as far as its element bounds it, meets the ball around all
  ///   boxes;
  /// - dist(centre, site) <= D + 2 radius, where D is an upper bound of the distance at the centre;
  /// - no half-space of the site has the whole box outside;
  /// - no surface point, of some that are near, is nearer than the site to all corners of the box.
  ///   Such a point is nearer everywhere in the box, as the site is convex: the difference of the
  ///   squared distances is a minimum of affine functions, hence concave, and smallest at a corner.
  /// @param reach of all boxes together.
  /// @param groups all that may hold closest points of the boxes.
  /// @param boxCount in [1, kMaxBoxes].
  /// @param lists one for each box.
  /// @return number of pairs of a site and a box that were tested.
  std::int64_t listSites(const BoxReach& reach, const GroupList& groups, const FrameBox* boxes,
    int boxCount, std::vector<int>* lists, Scratch& scratch) const;

  /// Bound of the rounding error of single precision near the grid and the mesh, in local units.
  float slack() const { return tree_.slack(); }

private:
  struct EdgeLine
  {
    glm::vec3 start;
    float length;
    glm::vec3 direction;
  };
  struct FacePlanes
  {
    HalfSpace plane;
    HalfSpace sides[3];
  };

  /// Makes what the tests need of sites.
  void prepare(const std::vector<int>& sites) const;
  FacePlanes facePlanes(int face) const;
  EdgeLine edgeLine(int edge) const;
  void collectSites(const BoxReach& reach, const GroupList& groups, std::vector<int>& sites) const;
  /// Appends to the boxes' lists, which have room for the whole of `parent`.
  void findNear(const std::vector<int>& parent, const FrameBox* boxes, int boxCount,
    Scratch& scratch) const;
  void prefetch(int site) const;
  /// Moves the sites that stay to the front of `near`, and returns their number.
  /// @param squaredDistances working memory, as long as `near`.
  std::size_t dropDominated(const FrameBox& box, std::vector<int>& near,
    std::vector<std::array<float, 8>>& squaredDistances) const;

  const SiteSet& sites_;
  SiteBounds bounds_;
  LazyTable<FacePlanes> facePlanes_;
  LazyTable<EdgeLine> edgeLines_;
  GroupTree tree_;
};

} // namespace medial

#pragma once

#include "medial/culling/half_space_packs.h"
#include "medial/sites/site_set.h"

#include <glm/glm.hpp>

#include <utility>
#include <vector>

namespace medial
{

/// An axis-aligned box in frame coordinates, by centre and half sides.
struct FrameBox
{
  glm::vec3 centre;
  glm::vec3 half;
};

/// What the distance from a point to a site lies between, to single precision.
struct DistanceBounds
{
  float lower;
  float upper;
};

/// Decides which sites can be closest to some point of a box. Conservative: it never drops a site
/// that is, so that it may change the time but not the result.
class CandidateFilter
{
public:
  explicit CandidateFilter(const SiteSet& sites);

  /// Working memory of one thread.
  struct Scratch
  {
    std::vector<float> lower;
    std::vector<std::pair<float, int>> kept;
  };

  /// Appends to `out`, in the order of `parent`, the sites that survive
  /// - dist(centre, site) <= D + 2 radius, D an upper bound of the distance at the centre, and
  /// - no half-space of the site has the whole box outside.
  /// @param parent candidates of a box that contains this one.
  void filter(const std::vector<int>& parent, const FrameBox& box, std::vector<int>& out,
    Scratch& scratch) const;

  /// Exact for edges and vertices; for a face the upper bound is left to its border where x does
  /// not project into it.
  DistanceBounds bounds(int site, const glm::vec3& x) const;

  /// All active sites, ascending: the candidates of everything.
  std::vector<int> allSites() const;

  /// What single precision may err by anywhere near the grid and the mesh, in frame units.
  float slack() const { return slack_; }

private:
  struct EdgeLine
  {
    glm::vec3 start;
    float length;
    glm::vec3 direction;
  };

  bool outside(int site, const FrameBox& box) const;

  const SiteSet& sites_;
  HalfSpacePacks packs_;
  std::vector<PlanePack> facePlanes_; ///< the three sides of the prism, then the face's plane
  std::vector<EdgeLine> edgeLines_;
  float slack_;
};

} // namespace medial

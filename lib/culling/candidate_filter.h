#pragma once

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

  /// A lower bound of the distance from x to a site, exact for edges and vertices.
  float lowerBound(int site, const glm::vec3& x) const { return this->bounds(site, x).lower; }

  /// All active sites, ascending: the candidates of everything.
  std::vector<int> allSites() const;

  /// What single precision may err by anywhere near the grid and the mesh, in frame units.
  float slack() const { return slack_; }

private:
  struct Interval
  {
    float lower;
    float upper;
  };
  struct EdgeLine
  {
    glm::vec3 start;
    float length;
    glm::vec3 direction;
  };

  Interval bounds(int site, const glm::vec3& x) const;
  bool outside(int site, const FrameBox& box) const;

  const SiteSet& sites_;
  std::vector<HalfSpace> facePlanes_;
  std::vector<EdgeLine> edgeLines_;
  float slack_;
};

} // namespace medial

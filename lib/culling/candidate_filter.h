#pragma once

#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// An axis-aligned box in local coordinates, by its centre and half its lengths.
struct FrameBox
{
  glm::vec3 centre;
  glm::vec3 half;
};

/// Points side by side, each with a distance within which to look for sites; local units.
struct PointLanes
{
  static constexpr int kMax = 8;

  int count = 0;
  alignas(32) std::array<float, kMax> x;
  alignas(32) std::array<float, kMax> y;
  alignas(32) std::array<float, kMax> z;
  /// The largest float if nothing is known.
  alignas(32) std::array<float, kMax> reach;
};

/// A site that may be within reach of the points whose bits are set.
struct NearSite
{
  int site;
  unsigned points;
};

/// Decides which sites can be closest to some point of a box. The filter is conservative: it never
/// drops a site that is, so it can change the time but not the result.
class CandidateFilter
{
public:
  /// Number of boxes that are filtered at once.
  static constexpr int kMaxBoxes = 8;

  CandidateFilter(const SiteSet& sites, const GridFrame& frame);

  /// Working memory of one thread.
  struct Scratch
  {
    std::array<std::vector<int>, kMaxBoxes> near; ///< survivors of the cheap tests
    std::vector<std::array<float, 8>> corners;    ///< squared distances to the corners of boxes
  };

  /// For each of up to kMaxBoxes boxes, appends to its `out`, in the order of `parent`, the sites
  /// that pass three tests:
  /// - dist(centre, site) <= D + 2 radius, where D is an upper bound of the distance at the centre;
  /// - no half-space of the site has the whole box outside;
  /// - no surface point, of some that are near, is nearer than the site to all corners of the box.
  ///   Such a point is nearer everywhere in the box, as the site is convex: the difference of the
  ///   squared distances is a minimum of affine functions, hence concave, and smallest at a corner.
  /// @param parent candidates of a box that contains these boxes.
  /// @param seeds a site near the centre of each box, or -1 if none is known; null for none at all.
  void filter(const std::vector<int>& parent, const FrameBox* boxes, const int* seeds, int boxCount,
    std::vector<int>* const* out, Scratch& scratch) const;

  /// Finds the sites in [begin, end) that may be within reach of a point, and all that may be
  /// closest to a point with unknown reach. `found` has room for the whole range.
  void near(const int* begin, const int* end, const PointLanes& points,
    std::vector<NearSite>& found) const;

  /// All active sites, ascending: the candidates of the whole space.
  std::vector<int> allSites() const;

  /// Bound of the rounding error of single precision near the grid and the mesh, in local units.
  float slack() const { return slack_; }

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

  bool seedDistances(const FrameBox* boxes, const int* seeds, int boxCount,
    std::array<float, kMaxBoxes>& squared) const;
  /// Appends to the boxes' lists, which have room for the whole of `parent`.
  void findNear(const std::vector<int>& parent, const FrameBox* boxes, const int* seeds,
    int boxCount, Scratch& scratch) const;
  void prefetch(int site) const;
  /// Moves the sites that stay to the front of `near`, and returns their number.
  /// @param squaredDistances working memory, as long as `near`.
  std::size_t dropDominated(const FrameBox& box, std::vector<int>& near,
    std::vector<std::array<float, 8>>& squaredDistances) const;

  const SiteSet& sites_;
  std::vector<FacePlanes> facePlanes_;
  std::vector<EdgeLine> edgeLines_;
  float slack_;
};

} // namespace medial

#pragma once

#include "culling/discs.h"
#include "culling/site_group.h"

#include <glm/glm.hpp>

#include <array>
#include <limits>
#include <vector>

namespace medial
{

/// An axis-aligned box in local coordinates, by its centre and half its lengths.
struct FrameBox
{
  static constexpr int kCorners = 8;

  glm::vec3 centre;
  glm::vec3 half;

  /// Returns a corner relative to the centre; bits of `i` are set for the upper ends of axes.
  glm::vec3 corner(int i) const
  {
    return half *
      glm::vec3((i & 1) != 0 ? 1.0f : -1.0f, (i & 2) != 0 ? 1.0f : -1.0f,
        (i & 4) != 0 ? 1.0f : -1.0f);
  }
};

/// The element nearest to a position.
struct NearestElement
{
  float squared = std::numeric_limits<float>::infinity(); ///< distance, local units
  int group = -1;
  int lane = 0;
  int tried = 0; ///< number of groups that the search has tried

  /// Tries the elements of a group. Of elements at the same distance the one with the lowest site
  /// stays, whatever the order of the groups.
  void tryGroup(const std::vector<SiteGroup>& groups, int next, const glm::dvec3& x);
};

/// How far the closest points of the positions in a box can be.
class BoxReach
{
public:
  /// @param nearest of all elements, from the box's centre.
  /// @param slack bound of the rounding of single precision there.
  BoxReach(const FrameBox& box, const NearestElement& nearest, float slack);
  /// @param distance from the centre within which all closest points lie.
  BoxReach(const FrameBox& box, float distance);

  const FrameBox& box() const { return box_; }
  /// Radius of the ball around the box.
  float radius() const { return radius_; }
  /// Squared distance from the centre within which all closest points lie.
  float squared() const { return squared_; }

  /// Adds a surface point near the box. A convex set that is farther than the point from all
  /// corners of the box is farther everywhere in the box: the difference of the two squared
  /// distances is convex, hence largest at a corner.
  void add(const glm::vec3& point);

  /// Returns which of eight discs may hold closest points, as bits.
  unsigned meets(const Discs& discs) const;

private:
  FrameBox box_;
  float radius_;
  float squared_;
  int pointCount_ = 0;
  std::array<Discs::Lanes, FrameBox::kCorners> points_; ///< squared distances from the corners
};

/// Some groups of a tree, with their discs side by side.
class GroupList
{
public:
  void clear();
  int size() const { return static_cast<int>(groups_.size()); }
  const std::vector<int>& groups() const { return groups_; }
  /// The discs of groups(), eight by eight.
  const std::vector<Discs>& discs() const { return discs_; }

  void add(int group, const Discs& discs, int lane);

  /// Lists those that may hold the closest point of some position in a box.
  void refine(const BoxReach& reach, GroupList& found) const;

  /// Returns the nearest element of these groups, in single precision.
  /// @param groups of the tree.
  /// @param start some element; the nearer it is, the faster the search.
  NearestElement nearest(const std::vector<SiteGroup>& groups, const glm::dvec3& x,
    const NearestElement& start) const;

private:
  std::vector<Discs> discs_;
  std::vector<int> groups_;
};

} // namespace medial

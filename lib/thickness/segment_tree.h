#pragma once

#include "base/box_tree.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace medial
{

/// Line segments, to be found by where they are. Both ends of one may be the same.
class SegmentTree
{
public:
  /// @param points two of every segment.
  void build(std::vector<glm::dvec3> points)
  {
    points_ = std::move(points);
    std::vector<glm::ivec3> ends;
    for (int first = 0; first < static_cast<int>(points_.size()); first += 2)
    {
      ends.emplace_back(first, first + 1, first + 1);
    }
    if (!ends.empty())
    {
      tree_.build(points_, ends);
    }
  }

  /// Whether a segment that counts is within a distance of a position.
  /// @param counts tells of a segment's number whether it does.
  template <typename Counts>
  bool isNear(const glm::dvec3& x, double distance, const Counts& counts) const
  {
    if (points_.empty())
    {
      return false;
    }
    const double limit = distance * distance;
    bool found = false;
    tree_.visitLeaves([&](const Box& box)
      { return !found && box.squaredDistance(x) <= limit * Box::kRoundedUp; },
      [&](const BoxTree::Node& leaf)
      {
        for (int slot = leaf.first; slot < leaf.first + leaf.count; ++slot)
        {
          const int segment = tree_.elements()[slot];
          found = found || (counts(segment) && this->squaredDistance(x, segment) <= limit);
        }
      });
    return found;
  }

private:
  double squaredDistance(const glm::dvec3& x, int segment) const
  {
    const glm::dvec3& a = points_[2 * segment];
    const glm::dvec3 along = points_[2 * segment + 1] - a;
    const double square = glm::dot(along, along);
    const double t = square > 0.0 ? std::clamp(glm::dot(x - a, along) / square, 0.0, 1.0) : 0.0;
    const glm::dvec3 gap = x - (a + t * along);
    return glm::dot(gap, gap);
  }

  std::vector<glm::dvec3> points_;
  BoxTree tree_;
};

} // namespace medial

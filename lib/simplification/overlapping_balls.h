#pragma once

#include "balls/ball.h"
#include "balls/bounding_tree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// Finds balls of other groups that overlap a ball.
class OverlappingBalls
{
public:
  /// @param balls must outlive this.
  explicit OverlappingBalls(const std::vector<Ball>& balls);

  /// @param groups one a ball, >= 0.
  void setGroups(const std::vector<int>& groups);

  struct Neighbour
  {
    int ball;
    double distance; ///< of the centres
  };

  /// Of the balls of other groups that overlap `ball` and do not just touch it, the one with the
  /// nearest centre, if that is not farther than `limit`; the one of lowest index among equals.
  std::optional<Neighbour> nearest(const Ball& ball, int group, double limit) const;

private:
  const std::vector<Ball>& balls_;
  BoundingTree tree_;
  std::vector<int> groups_;
  std::vector<int> groupOfNode_; ///< of all its balls, or kSeveral
};

} // namespace medial

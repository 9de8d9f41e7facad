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

  /// @param groups one per ball, >= 0.
  void setGroups(const std::vector<int>& groups);

  struct Neighbour
  {
    int ball;
    double distance; ///< of the centres
  };

  /// Among the balls of other groups that overlap `ball` by more than a touch, returns the one with
  /// the nearest centre if that is within `limit`; of equal ones that of lowest index.
  std::optional<Neighbour> nearest(const Ball& ball, int group, double limit) const;

private:
  const std::vector<Ball>& balls_;
  BoundingTree tree_;
  std::vector<int> groups_;
  std::vector<int> groupOfNode_; ///< group of all balls of a node, or kSeveral
};

} // namespace medial

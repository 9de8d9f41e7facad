#pragma once

#include "simplification/ball_quadric.h"

#include <optional>
#include <vector>

namespace medial
{

/// Balls sorted by their centres into a binary tree, whose nodes know the box of the centres, the
/// largest radius and, if there is just one, the group of their balls.
class BallTree
{
public:
  explicit BallTree(std::vector<Ball> balls);

  /// Labels balls for nearestOverlapping().
  /// @param groups one a ball, in the order of the constructor; >= 0.
  void setGroups(const std::vector<int>& groups);

  /// Whether `point` lies more than `depth` below the boundary of some ball.
  bool covers(const glm::dvec3& point, double depth) const;

  /// Distance of the nearest centre, or `limit` if none is nearer.
  double distance(const glm::dvec3& point, double limit) const;

  struct Neighbour
  {
    int ball;
    double distance; ///< of the centres
  };

  /// Of the balls of other groups that overlap `ball` and do not just touch it, the one with the
  /// nearest centre, if that is not farther than `limit`; the one of lowest index among equals.
  std::optional<Neighbour> nearestOverlapping(const Ball& ball, int group, double limit) const;

private:
  struct Node
  {
    glm::dvec3 min, max;
    double radius;
    int begin, end; ///< in order_
    int left = -1;  ///< children: left and left + 1; -1 for a leaf
    int group = 0;  ///< -1: several
  };

  void split(int node);
  void fit(Node& node) const;
  double distanceTo(const Node& node, const glm::dvec3& point) const;
  bool covers(int node, const glm::dvec3& point, double depth) const;
  void descend(int node, const glm::dvec3& point, double& best) const;
  void descend(int node, const Ball& ball, int group, std::optional<Neighbour>& best,
    double& limit) const;

  std::vector<Ball> balls_;
  std::vector<int> order_;
  std::vector<int> groups_;
  std::vector<Node> nodes_; ///< children after their parents
};

} // namespace medial

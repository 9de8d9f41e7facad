#pragma once

#include "axis/smooth_curve.h"
#include "skeleton/solid_probe.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace medial
{

/// How far a branch reaches out of the balls of all others.
struct BranchRise
{
  double length = 0.0; ///< of the largest part of a ball's radius and its way out of the others
  /// Radius of the largest ball with its centre outside the others, 0 if none is. In a sheet or a
  /// ridge it is the way to its nearer border, where that is shortest; up to twice `length`.
  double size = 0.0;
  std::vector<std::size_t> neighbours; ///< branches that this depends on, ascending
};

/// The largest balls in a solid around the points of branches, in local units. A branch is known by
/// a number.
class BranchBalls
{
public:
  explicit BranchBalls(const SolidProbe& probe)
    : probe_(probe)
  {
  }

  /// Takes the balls of a branch in place of those that it had; none for a curve without points.
  void set(std::size_t branch, const Curve& curve);
  /// Gives the balls of a branch the order of its curve from the other end.
  void reverse(std::size_t branch);
  /// Gives a branch those of another as well, after its own; the other has none then.
  void join(std::size_t branch, std::size_t other);

  /// Returns how far a branch reaches out of the others.
  /// @param branch of which the first point belongs to others too.
  /// @param enough where the length is this many sizes or more, the size returned may be too large,
  ///   but not so large that the length is fewer sizes than that.
  BranchRise rise(std::size_t branch, double enough) const;

private:
  struct Ball
  {
    glm::dvec3 centre;
    double radius;
  };
  /// Some neighbouring balls of a branch and a ball that contains them.
  struct Group
  {
    Ball around;
    std::size_t begin;
    std::size_t end;
  };
  struct BallsOfBranch
  {
    explicit BallsOfBranch(std::vector<Ball> all = {});

    std::vector<Ball> balls;
    std::vector<Group> groups;
  };
  /// Where a point is outside of the balls of all branches but one.
  struct Outside
  {
    double distance; ///< to the nearest ball, negative inside
    std::size_t branch;
    glm::dvec3 centre; ///< of that ball
  };

  /// Half the width, at most `high`, of what rises to a ball, in the direction in which it is wide.
  /// @param rise its direction, which is not that of the branch where this runs along a ridge.
  double halfWidth(const Ball& ball, const glm::dvec3& rise, double high) const;
  Outside outside(const glm::dvec3& x, std::size_t except) const;

  const SolidProbe& probe_;
  std::vector<BallsOfBranch> branches_;
};

} // namespace medial

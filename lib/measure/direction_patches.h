#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace medial
{

/// All directions, in patches of equal area between circles of latitude and meridians.
class DirectionPatches
{
public:
  static const DirectionPatches& instance();

  std::size_t size() const { return centres_.size(); }
  /// Returns the direction in the middle of a patch.
  const glm::dvec3& centre(std::size_t patch) const { return centres_[patch]; }
  /// Returns the largest angle, in radians, between a direction of a patch and its centre.
  double radius() const { return radius_; }
  /// Maps the unit square to a patch, and equal areas to equal areas.
  glm::dvec3 direction(std::size_t patch, double u, double v) const;

private:
  DirectionPatches();

  std::vector<glm::dvec3> centres_;
  double radius_ = 0.0;
};

} // namespace medial

#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace medial
{

/// All directions in patches of equal area, between circles of latitude and meridians.
class DirectionPatches
{
public:
  static const DirectionPatches& instance();

  std::size_t size() const { return centres_.size(); }
  /// A direction of the patch.
  const glm::dvec3& centre(std::size_t patch) const { return centres_[patch]; }
  /// No direction of a patch is farther from its centre than this angle, in radians.
  double radius() const { return radius_; }
  /// Maps the unit square to a patch, areas in proportion.
  glm::dvec3 direction(std::size_t patch, double u, double v) const;

private:
  DirectionPatches();

  std::vector<glm::dvec3> centres_;
  double radius_ = 0.0;
};

} // namespace medial

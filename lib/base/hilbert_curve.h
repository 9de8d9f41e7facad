#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace medial
{

/// Hilbert's curve through a cube. In the order of the curve, neighbours are close together.
class HilbertCurve
{
public:
  /// @param low, high corners of a box, the lower and the upper one; a cube around it is meant.
  HilbertCurve(const glm::dvec3& low, const glm::dvec3& high);

  /// Returns the place on the curve of a position; of the nearest one in the cube if it is outside.
  std::uint64_t placeOf(const glm::dvec3& x) const;

private:
  glm::dvec3 low_;
  double scale_; ///< cells per unit
};

} // namespace medial

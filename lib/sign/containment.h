#pragma once

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// A triangle of the closed surface of a solid.
struct SolidTriangle
{
  std::array<glm::dvec3, 3> corners;
  int solid;
  int weight; ///< how often it counts, negative if turned round
};

/// Winding numbers of points with respect to each of many solids.
class Containment
{
public:
  /// @param triangles closed surfaces of all solids.
  Containment(const std::vector<SolidTriangle>& triangles, std::vector<glm::dvec3> points);

  /// Returns the solids around a point, ascending: those whose winding number is not 0.
  const std::vector<int>& solidsAround(int point) const { return around_[point]; }

private:
  std::vector<std::vector<int>> around_;
};

} // namespace medial

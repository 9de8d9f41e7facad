#pragma once

#include <glm/glm.hpp>

#include <array>
#include <map>
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
  /// @param triangles closed surfaces of all solids, or some triangles of them.
  Containment(const std::vector<SolidTriangle>& triangles, std::vector<glm::dvec3> points);

  /// Returns what the triangles of each solid add to a point's winding number: solids whose number
  /// is not 0 in the end contain it.
  const std::map<int, int>& windingsAt(int point) const { return windings_[point]; }

private:
  std::vector<std::map<int, int>> windings_;
};

} // namespace medial

#pragma once

#include "medial/grid.h"

#include <glm/glm.hpp>

namespace medial
{

inline glm::dvec3 toVector(const Point3& point)
{
  return { point[0], point[1], point[2] };
}

inline Point3 toPoint(const glm::dvec3& vector)
{
  return { vector.x, vector.y, vector.z };
}

} // namespace medial

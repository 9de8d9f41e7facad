#pragma once

#include <glm/glm.hpp>

namespace medial
{

/// A ball; a point is a ball of radius 0.
struct Ball
{
  glm::dvec3 centre{ 0.0 };
  double radius = 0.0;
};

///@{
/// Turns balls into points of R^4, with the radius as fourth coordinate, and back. There they can
/// be added and scaled.
inline glm::dvec4 toVector(const Ball& ball)
{
  return { ball.centre, ball.radius };
}

inline Ball toBall(const glm::dvec4& vector)
{
  return { glm::dvec3(vector), vector.w };
}
///@}

} // namespace medial

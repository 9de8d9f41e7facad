#pragma once

#include "simplification/ball_quadric.h"

#include <optional>
#include <vector>

namespace medial
{

/// The planes that touch three balls from one side each have the unit normal slope +- sine * up.
struct Slab
{
  glm::dvec3 slope; ///< in the plane of the centres, where radii grow against it
  glm::dvec3 up;    ///< unit normal of that plane
  double sine;      ///< of half the angle between the two normals, (0, 1]
  double area;      ///< of the triangle of centres

  glm::dvec3 normal(double side) const { return slope + side * sine * up; }
};

/// The planes that touch two balls have the unit normals slope * axis + sine * radial, radial any
/// unit vector at right angles to the axis.
struct Cone
{
  glm::dvec3 axis; ///< unit vector between the centres
  double slope;
  double sine; ///< (0, 1]
  double length;
};

///@{
/// Nothing where no plane touches all balls, since one lies inside another or inside the hull of
/// the others, or where centres coincide or lie on a line.
std::optional<Slab> slabOf(const Ball& a, const Ball& b, const Ball& c);
std::optional<Cone> coneOf(const Ball& a, const Ball& b);
///@}

glm::dvec3 anyPerpendicular(const glm::dvec3& unitVector);

/// Whether up to four balls have a common interior point.
bool haveCommonPoint(const std::vector<Ball>& balls);

} // namespace medial

#include "sites/local_coordinates.h"

#include "sites/grid_frame.h"

namespace medial
{

LocalCoordinates LocalCoordinates::around(const Bounds& bounds, double margin)
{
  return GridFrame(makeGrid(bounds, kMaxDimension, margin));
}

glm::dvec3 LocalCoordinates::toLocal(const Point3& world) const
{
  return (glm::dvec3(world[0], world[1], world[2]) - centre) / unit;
}

Point3 LocalCoordinates::toWorld(const glm::dvec3& local) const
{
  const glm::dvec3 world = centre + local * unit;
  return { world.x, world.y, world.z };
}

} // namespace medial

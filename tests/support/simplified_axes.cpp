#include "support/simplified_axes.h"

#include "medial/simplification.h"
#include "support/axes.h"
#include "support/brute_force.h"
#include "support/medial_checks.h"
#include "support/shapes.h"

namespace medial::test
{

MedialAxis simplified(const MedialAxis& axis, std::int64_t maxSpheres)
{
  SimplificationOptions options;
  options.maxSpheres = maxSpheres;
  return simplifyAxis(axis, options);
}

MedialAxis axisOf(const TriangleMesh& mesh, double spacing, std::int64_t maxSpheres, double angle)
{
  MedialAxisOptions options;
  options.angle = angle;
  options.maxSpheres = maxSpheres;
  return computeMedialAxis(mesh, offCentreGrid(mesh, spacing), options);
}

MedialAxis plate()
{
  AxisBuilder builder;
  builder.addSheet({ 1.0, 2.0, 3.0 }, { 3.0, 0.0, 0.0 }, { 0.0, 1.6, 1.2 }, 24, 0.4);
  return builder.axis;
}

MedialAxis sphereSheet(double R, double radius)
{
  const TriangleMesh mesh = icosphere(R, 3);
  AxisBuilder builder;
  for (const Point3& point : mesh.points)
  {
    builder.add(point, radius);
  }
  for (const auto& t : mesh.triangles)
  {
    builder.axis.triangles.push_back({ t[0], t[1], t[2] });
  }
  return builder.axis;
}

double nearest(const MedialAxis& axis, const Point3& point)
{
  return distancesToPoints({ point }, axis.points)[0];
}

} // namespace medial::test

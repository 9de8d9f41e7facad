#include "pipeline/axis_stages.h"

#include "axis/sheet_selection.h"
#include "base/separation_angle.h"
#include "medial/error.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <string>

namespace medial
{
namespace
{

std::array<float, 3> narrowed(const Point3& point)
{
  return { static_cast<float>(point[0]), static_cast<float>(point[1]),
    static_cast<float>(point[2]) };
}

void checkLength(const char* name, double length)
{
  if (!(length >= 0.0) || !std::isfinite(length))
  {
    throw Error(ErrorCode::InvalidInput,
      "minimum " + std::string(name) + " " + std::to_string(length) + " is outside [0, infinity)");
  }
}

} // namespace

void checkAxisOptions(const MedialAxisOptions& options)
{
  checkSeparationAngle(options.angle);
  checkLength("lambda", options.lambda);
  checkLength("radius", options.radius);
  if (options.topology == Topology::Preserve && options.representation == Representation::Points)
  {
    throw Error(ErrorCode::InvalidInput,
      "points have no topology to preserve: the representation must be surface or faces");
  }
  if (options.maxSpheres < 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "maximum number of spheres " + std::to_string(options.maxSpheres) +
        " is negative; allowed: 0 (no limit) or more");
  }
  if (options.maxSpheres > 0 && options.representation == Representation::Points)
  {
    throw Error(ErrorCode::InvalidInput,
      "maximum number of spheres " + std::to_string(options.maxSpheres) +
        " for an axis of points, which has no cells to simplify; allowed: surface or faces");
  }
}

double selectionAngle(const MedialAxisOptions& options)
{
  const bool byDirections =
    options.representation == Representation::Faces && options.topology == Topology::Selected;
  return byDirections ? options.angle : bandAngle(options.angle);
}

void setAxisPoints(const BisectorPoints& points, const GridFrame& frame, MedialAxis& axis)
{
  const std::size_t count = points.points.size();
  axis.points.resize(count);
  axis.radius.resize(count);
  axis.separationAngle.resize(count);
  axis.lambda.resize(count);
  axis.closestPointA.resize(count);
  axis.closestPointB.resize(count);
  tbb::parallel_for(std::size_t{ 0 }, count,
    [&](std::size_t p)
    {
      const BisectorPoint& point = points.points[p];
      const double radius = point.radius() * frame.unit;
      const double angle = point.separationAngle();
      axis.points[p] = frame.toWorld(point.position);
      axis.radius[p] = static_cast<float>(radius);
      axis.separationAngle[p] = static_cast<float>(glm::degrees(angle));
      axis.lambda[p] = static_cast<float>(radius * std::sin(0.5 * angle));
      axis.closestPointA[p] = narrowed(frame.toWorld(point.a.point));
      axis.closestPointB[p] = narrowed(frame.toWorld(point.b.point));
    });
}

} // namespace medial

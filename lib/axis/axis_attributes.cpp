#include "axis/axis_attributes.h"

#include "base/huge_pages.h"

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

namespace medial
{
namespace
{

std::array<float, 3> narrowed(const Point3& point)
{
  return { static_cast<float>(point[0]), static_cast<float>(point[1]),
    static_cast<float>(point[2]) };
}

} // namespace

void resizeAxisPoints(std::size_t count, MedialAxis& axis)
{
  resizeLarge(axis.points, count);
  resizeLarge(axis.radius, count);
  resizeLarge(axis.separationAngle, count);
  resizeLarge(axis.lambda, count);
  resizeLarge(axis.closestPointA, count);
  resizeLarge(axis.closestPointB, count);
}

void setAxisPoints(const BisectorPoints& points, const GridFrame& frame, MedialAxis& axis)
{
  const std::size_t count = points.points.size();
  resizeAxisPoints(count, axis);
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

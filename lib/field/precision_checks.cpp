#include "field/precision_checks.h"

#include "medial/error.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace medial
{
namespace
{

/// Largest distance of a grid point from the surface, local units. Shaders and depths are of single
/// precision; beyond this they would be more than 1e-2 off.
constexpr double kMaxDistance = 32768.0;

/// Squares of distances must fit single precision.
constexpr double kMaxReach = 1e18;

void requireReach(const char* what, double reach)
{
  if (!(reach <= kMaxReach))
  {
    std::ostringstream message;
    message << what << " reaches " << reach
            << " times the finest spacing from the middle of the grid, more than " << kMaxReach;
    throw Error(ErrorCode::InvalidInput, message.str());
  }
}

} // namespace

void requireSinglePrecision(const Bounds& bounds, const GridFrame& frame)
{
  requireReach("the grid", frame.reach());
  const glm::dvec3 low = glm::abs(frame.toLocal(bounds.min));
  const glm::dvec3 high = glm::abs(frame.toLocal(bounds.max));
  requireReach("the mesh", glm::length(glm::max(low, high)));
}

void requireNear(const FieldJob& job)
{
  double nearest = std::numeric_limits<double>::max();
  for (const Point3& point : job.mesh.points)
  {
    nearest = std::min(nearest, glm::length(job.frame.toLocal(point)));
  }
  const double farthest = nearest + job.frame.reach();
  if (farthest > kMaxDistance)
  {
    std::ostringstream message;
    message << "grid points may be " << farthest << " times the finest spacing away from the mesh, "
            << "more than " << kMaxDistance << ": this needs the engine processor";
    throw Error(ErrorCode::InvalidInput, message.str());
  }
}

} // namespace medial

#include "field/reach.h"

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

} // namespace

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

#include "pipeline/axis_options.h"

#include "axis/sheets/sheet_selection.h"
#include "base/range_check.h"
#include "base/separation_angle.h"
#include "medial/error.h"

#include <cmath>
#include <string>

namespace medial
{
namespace
{

void checkLength(const char* name, double length)
{
  if (!(length >= 0.0) || !std::isfinite(length))
  {
    throwOutside(name, length, "[0, infinity)");
  }
}

} // namespace

void checkAxisOptions(const MedialAxisOptions& options)
{
  checkSeparationAngle(options.angle);
  checkLength("minimum lambda", options.lambda);
  checkLength("minimum radius", options.radius);
  if (options.topology == Topology::Preserve && options.representation == Representation::Points)
  {
    throw Error(ErrorCode::InvalidInput,
      "points have no topology to preserve: the representation must be surface or faces");
  }
  if (options.maxSpheres < 0)
  {
    throwOutside("maximum number of spheres", options.maxSpheres, "[0, infinity)");
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

AxisLimits limitsOf(const MedialAxisOptions& options, const GridFrame& frame)
{
  return { glm::radians(options.angle), options.lambda / frame.unit, options.radius / frame.unit };
}

Side sideOf(Side wanted, bool hasSign)
{
  return hasSign ? wanted : Side::Both;
}

} // namespace medial

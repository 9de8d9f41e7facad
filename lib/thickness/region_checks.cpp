#include "thickness/region_checks.h"

#include "medial/error.h"

#include <cmath>
#include <string>

namespace medial
{
namespace
{

/// Values are single precision: this share beyond a limit is rounding.
constexpr double kRounding = 1e-6;

} // namespace

Beyond beyondOf(float value, bool atEdge, const ThicknessLimits& limits)
{
  const auto thickness = static_cast<double>(value);
  if (limits.min && thickness < *limits.min * (1.0 - kRounding))
  {
    return atEdge ? Beyond::Nothing : Beyond::Min;
  }
  return limits.max && thickness > *limits.max * (1.0 + kRounding) ? Beyond::Max : Beyond::Nothing;
}

void requireValuesOf(const TriangleMesh& mesh, const Thickness& thickness)
{
  const std::size_t triangles = mesh.triangles.size();
  if (thickness.triangleValues.size() != triangles ||
    thickness.triangleAtEdge.size() != triangles || thickness.values.size() != mesh.points.size() ||
    thickness.atEdge.size() != mesh.points.size())
  {
    throw Error(ErrorCode::InvalidInput,
      "thickness has values of " + std::to_string(thickness.triangleValues.size()) +
        " triangles, the mesh has " + std::to_string(triangles) +
        "; ThicknessOptions::cells must be on");
  }
}

Grid gridForInside(const Bounds& bounds)
{
  constexpr int kResolution = 32;
  return makeGrid(bounds, kResolution);
}

void requireSign(const SignReport& sign)
{
  if (sign.method == SignMethod::None)
  {
    throw Error(ErrorCode::InvalidInput,
      "limits of the thickness of one side need a mesh with an inside; " + sign.reason);
  }
}

} // namespace medial

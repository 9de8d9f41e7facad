#pragma once

#include "base/half_line.h"
#include "sites/closest_point.h"

#include <glm/glm.hpp>

#include <limits>
#include <optional>

namespace medial
{

/// Where a ray starts: at a point of the mesh, or inside a face. It does not end on faces there.
struct RayStart
{
  int point = -1; ///< -1 inside a face
  int face = -1;  ///< -1 at a point

  /// Whether a face is one of those that the ray starts on.
  bool isOn(int other, const glm::ivec3& corners) const
  {
    return point < 0 ? other == face
                     : corners[0] == point || corners[1] == point || corners[2] == point;
  }
};

/// Where a ray ends.
struct RayEnd
{
  double distance = std::numeric_limits<double>::infinity();
  int face = -1;
  glm::dvec3 normal{ 0.0 }; ///< of the face
};

/// Answers questions about the surface, wherever they lead, in local coordinates.
class SurfaceAnswers
{
public:
  virtual ~SurfaceAnswers() = default;

  /// Returns the closest surface point; its site is -1 if there is none within the limit. Sites
  /// that meet at the place that is asked for have their own numbers; others may have any.
  /// @param limit surface points at this distance or beyond do not count.
  virtual SitePoint closest(const glm::dvec3& x, double limit) = 0;
  /// Returns where a ray reaches the opposite surface; nothing if it does not.
  virtual std::optional<RayEnd> opposite(const HalfLine& ray, const RayStart& start) = 0;
  /// Whether a convex edge or tip is within a distance.
  virtual bool nearConvexEdge(const glm::dvec3& x, double distance) = 0;
  /// Whether a border lies at a place whose face is turned away from a direction; see
  /// SurfaceBorders::isSeam().
  virtual bool isSeam(const glm::dvec3& place, const glm::dvec3& direction) = 0;
};

} // namespace medial

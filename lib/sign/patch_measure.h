#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cmath>

namespace medial
{

/// A triangle of a patch, or of a lid of its holes, as it counts in the patch.
struct CountedTriangle
{
  std::array<glm::dvec3, 3> corners;
  int weight;
};

/// Sums up a patch as the surface of a solid. The order of triangles decides about the last bits.
struct PatchMeasure
{
  double area = 0.0;
  double lidArea = 0.0;
  double volume = 0.0; ///< within the patch and its lids; negative if it faces inwards

  /// @param origin a corner of the patch.
  void add(const CountedTriangle& triangle, const glm::dvec3& origin, bool isLid)
  {
    const glm::dvec3 a = triangle.corners[0] - origin;
    const glm::dvec3 normal =
      glm::cross(triangle.corners[1] - origin - a, triangle.corners[2] - origin - a);
    (isLid ? lidArea : area) += 0.5 * glm::length(normal);
    volume += triangle.weight * glm::dot(a, normal) / 6.0;
  }

  /// Whether the patch encloses a volume up to small holes.
  bool isSolid() const
  {
    // Lids may take this share of a patch's area.
    constexpr double kMaxLidShare = 0.25;
    // Solids flatter than this, as volume over area to the power of 3/2, have no inside.
    constexpr double kMinVolumeShare = 1e-9;
    return lidArea <= kMaxLidShare * area &&
      std::abs(volume) > kMinVolumeShare * area * std::sqrt(area);
  }
};

/// Number of places at which a patch of so many triangles is tested for being inside another one.
inline std::size_t probesOf(std::size_t triangles)
{
  constexpr std::size_t kProbes = 15;
  return triangles < kProbes ? triangles : kProbes;
}

/// Returns which of its triangles has a place where a patch is tested.
inline std::size_t probedTriangle(std::size_t probe, std::size_t triangles)
{
  return (2 * probe + 1) * triangles / (2 * probesOf(triangles));
}

/// Whether a patch is inside a solid in which so many of its places are. Solids that overlap have
/// places inside each other, too.
inline bool isContained(std::size_t inside, std::size_t places)
{
  return 5 * inside > 4 * places;
}

} // namespace medial

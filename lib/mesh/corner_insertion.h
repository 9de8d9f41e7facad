#pragma once

#include "base/checkpoint.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace medial
{

/// A corner of a triangle that lies on the edge between the others, but for rounding: at both ends
/// of that edge the angle is at most kMaxFlatAngle. Points have their numbers in the whole mesh.
struct CornerOnEdge
{
  std::array<std::int64_t, 2> ends; ///< ascending
  std::int64_t corner;
  Point3 position; ///< of the corner
};

/// Largest angle at the ends of an edge, radians, under which the corner opposite lies on it.
constexpr double kMaxFlatAngle = 2e-5;
/// Triangles without area on top of each other need several insertions.
constexpr int kMaxInsertions = 64;

/// Returns the corners of a mesh that lie on edges, each with the edge of its triangle.
/// @param numberOf returns the number of a point of the mesh.
std::vector<CornerOnEdge> cornersOnEdges(const TriangleMesh& mesh,
  const std::function<std::int64_t(int)>& numberOf, const Checkpoint& checkpoint);

/// Whether some triangle has an area, and no corner on an edge.
bool hasUsableTriangle(const TriangleMesh& mesh);

/// Divides triangles at corners of others that lie on their edges, so that both share their points.
/// Triangles without area fill the gaps between such edges; those that fill none any more go.
class CornerInsertion
{
public:
  /// @param corners of the whole mesh. Of several on an edge the one with the lowest number counts.
  explicit CornerInsertion(const std::vector<CornerOnEdge>& corners);

  /// Returns the number of a point of the mesh.
  using NumberOf = std::function<std::int64_t(int)>;
  /// Returns the point of the mesh that is a corner, between two points of the mesh.
  using PointOf = std::function<int(const CornerOnEdge&, int, int)>;

  /// @param maxEdge names what the triangles are for, if they are too many.
  /// @throws Error InvalidInput for more triangles than subdivide() makes.
  void divide(double maxEdge, const NumberOf& numberOf, const PointOf& pointOf,
    const Checkpoint& checkpoint, TriangleMesh& mesh) const;

private:
  struct HashOfEnds
  {
    std::size_t operator()(const std::array<std::int64_t, 2>& ends) const
    {
      const auto low = static_cast<std::uint64_t>(ends[0]);
      const auto high = static_cast<std::uint64_t>(ends[1]);
      return static_cast<std::size_t>(
        (low * 0x9e3779b97f4a7c15u ^ high) * 0x9e3779b97f4a7c15u >> 7);
    }
  };

  /// Returns the points of the mesh that divide an edge, from a to b.
  std::vector<int> pointsBetween(int a, int b, const NumberOf& numberOf,
    const PointOf& pointOf) const;

  std::unordered_map<std::array<std::int64_t, 2>, CornerOnEdge, HashOfEnds> cornerOn_;
};

} // namespace medial

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Finds the triangles that form an oriented manifold when they are added in their order: those
/// that a half-edge mesh accepts.
///
/// Around a point, the triangles of a manifold form fans, each from one boundary edge to another. A
/// triangle begins a fan, prolongs one, joins two, or closes the only one of its point; it may not
/// close one of several.
class ManifoldPart
{
public:
  using Triangle = std::array<int, 3>;

  /// @param points, edges their numbers in the whole mesh.
  ManifoldPart(std::size_t points, int edges);

  /// Adds a triangle. False if it does not fit and was left out.
  /// @param sides its edges, in the order of its corners.
  bool add(const Triangle& corners, const Triangle& sides);

  /// Points whose triangles form several fans.
  int pointsWithGaps() const;

private:
  bool hasFace(std::size_t end) const { return faces_[end / 2] > 0; }

  /// Whether there is room for corner i and the side that starts there.
  bool fits(const Triangle& corners, const Triangle& sides, int i) const;
  void link(const Triangle& corners, const Triangle& sides, int i);

  std::vector<int> fans_;            ///< per point: its fans
  std::vector<char> closed_;         ///< per point: whether triangles are all around it
  std::vector<std::uint8_t> faces_;  ///< per edge: its triangles
  std::vector<int> starts_;          ///< per edge: the first point of its last triangle's side
  std::vector<std::size_t> fanEnds_; ///< per end of a boundary edge: that at its fan's other end
};

} // namespace medial

#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// Medial balls, edges and triangles between them.
struct BallMesh
{
  struct Ball
  {
    glm::dvec3 centre;
    double radius;
  };

  std::vector<Ball> balls;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Merges equal balls, which get another order.
  void mergeEqual();

  void append(const BallMesh& other)
  {
    const auto first = static_cast<std::uint32_t>(balls.size());
    balls.insert(balls.end(), other.balls.begin(), other.balls.end());
    for (const auto& [a, b] : other.edges)
    {
      edges.push_back({ first + a, first + b });
    }
    for (const auto& [a, b, c] : other.triangles)
    {
      triangles.push_back({ first + a, first + b, first + c });
    }
  }
};

} // namespace medial

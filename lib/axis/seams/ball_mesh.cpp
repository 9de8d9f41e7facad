#include "axis/seams/ball_mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace medial
{

void BallMesh::mergeEqual()
{
  const auto placeOf = [&](std::uint32_t ball)
  {
    const auto& [centre, radius] = balls[ball];
    return std::make_tuple(centre.z, centre.y, centre.x, radius);
  };
  std::vector<std::uint32_t> order(balls.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return placeOf(a) < placeOf(b); });
  std::vector<Ball> merged;
  std::vector<std::uint32_t> numbers(balls.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i == 0 || placeOf(order[i - 1]) != placeOf(order[i]))
    {
      merged.push_back(balls[order[i]]);
    }
    numbers[order[i]] = static_cast<std::uint32_t>(merged.size() - 1);
  }
  balls = std::move(merged);
  for (auto& edge : edges)
  {
    edge = { numbers[edge[0]], numbers[edge[1]] };
  }
  for (auto& triangle : triangles)
  {
    triangle = { numbers[triangle[0]], numbers[triangle[1]], numbers[triangle[2]] };
  }
}

} // namespace medial

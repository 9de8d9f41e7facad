#include "thickness/ball_families.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

constexpr float kTile = 8.0f;

/// Sorts the ids of simplices and the simplices, and drops repeated ones.
template <typename Simplex>
void sortUnique(std::vector<Simplex>& simplices)
{
  tbb::parallel_for(std::size_t{ 0 }, simplices.size(),
    [&](std::size_t s) { std::sort(simplices[s].begin(), simplices[s].end()); });
  tbb::parallel_sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  simplices.shrink_to_fit();
}

template <typename Simplex>
void renumber(const std::vector<std::uint32_t>& numbers, std::vector<Simplex>& simplices)
{
  tbb::parallel_for(std::size_t{ 0 }, simplices.size(),
    [&](std::size_t s)
    {
      for (std::uint32_t& ball : simplices[s])
      {
        ball = numbers[ball];
      }
    });
}

} // namespace

BallFamilies::BallFamilies(const Grid& grid, double angle)
  : unit_(*std::min_element(grid.spacing.begin(), grid.spacing.end()))
  , origin_(grid.origin[0], grid.origin[1], grid.origin[2])
  , step_(glm::dvec3(grid.spacing[0], grid.spacing[1], grid.spacing[2]) / unit_)
  , stretch_(static_cast<float>(1.0 / std::cos(0.5 * angle)))
{
}

std::uint32_t BallFamilies::add(const glm::vec3& centre, float radius)
{
  balls_.emplace_back(centre, radius);
  maxRadius_ = std::max(maxRadius_, radius);
  return static_cast<std::uint32_t>(balls_.size() - 1);
}

void BallFamilies::add(const MedialAxis& axis)
{
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> ids(axis.points.size(), kNone);
  const auto idOf = [&](std::int64_t p)
  {
    if (ids[p] == kNone)
    {
      const Point3& point = axis.points[p];
      ids[p] = this->add(glm::vec3((glm::dvec3(point[0], point[1], point[2]) - origin_) / unit_),
        static_cast<float>(static_cast<double>(axis.radius[p]) / unit_));
    }
    return ids[p];
  };
  for (const auto& quad : axis.quads)
  {
    this->joinQuad({ idOf(quad[0]), idOf(quad[1]), idOf(quad[2]), idOf(quad[3]) });
  }
  for (const auto& triangle : axis.triangles)
  {
    this->joinTriangle({ idOf(triangle[0]), idOf(triangle[1]), idOf(triangle[2]) });
  }
  for (const auto& line : axis.lines)
  {
    this->join(idOf(line[0]), idOf(line[1]));
  }
  for (const std::int64_t vertex : axis.vertices)
  {
    this->join(idOf(vertex), idOf(vertex));
  }
}

void BallFamilies::add(const BallMesh& mesh)
{
  const auto first = static_cast<std::uint32_t>(balls_.size());
  for (const BallMesh::Ball& ball : mesh.balls)
  {
    this->add(glm::vec3((ball.centre - origin_) / unit_), static_cast<float>(ball.radius / unit_));
  }
  for (const auto& [a, b] : mesh.edges)
  {
    this->join(first + a, first + b);
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    this->joinTriangle({ first + a, first + b, first + c });
  }
}

void BallFamilies::joinTriangle(const Triangle& triangle)
{
  triangles_.push_back(triangle);
  for (int corner = 0; corner < 3; ++corner)
  {
    this->join(triangle[corner], triangle[(corner + 1) % 3]);
  }
}

void BallFamilies::joinQuad(const std::array<std::uint32_t, 4>& quad)
{
  const int from =
    this->length(quad[0], quad[2]) <= this->length(quad[1], quad[3]) ? 0 : 1; // of the diagonal
  this->joinTriangle({ quad[from], quad[from + 1], quad[from + 2] });
  this->joinTriangle({ quad[from], quad[from + 2], quad[(from + 3) % 4] });
}

/// Sets the reach and the length of an item, and returns its bounds.
ItemBounds BallFamilies::measure(std::uint32_t number)
{
  Item& item = items_[number];
  const glm::vec4& common = this->ballOf(item);
  ItemBounds bounds = ItemBounds::nothing();
  bounds.add(glm::dvec3(common), static_cast<double>(common.w));
  for (std::uint32_t e = item.edgesBegin; e < items_[number + 1].edgesBegin; ++e)
  {
    const glm::vec4& ball = balls_[edges_[e][1]];
    bounds.add(glm::dvec3(ball), static_cast<double>(ball.w));
    item.length = std::max(item.length, this->length(edges_[e][0], edges_[e][1]));
  }
  for (std::uint32_t t = item.trianglesBegin; t < items_[number + 1].trianglesBegin; ++t)
  {
    item.length = std::max(item.length, this->length(triangles_[t][1], triangles_[t][2]));
  }
  item.reach = static_cast<float>(bounds.reach);
  return bounds;
}

/// Sorts the balls by tiles of the grid, so that neighbours are close together in memory, and
/// merges equal ones.
void BallFamilies::sortBalls()
{
  const glm::vec3 perTile = 1.0f / (kTile * step_);
  const auto keyOf = [&](const glm::vec4& ball)
  {
    const glm::vec3 tile = glm::floor(glm::vec3(ball) * perTile);
    return std::make_tuple(tile.z, tile.y, tile.x, ball.z, ball.y, ball.x, ball.w);
  };
  std::vector<std::uint32_t> order(balls_.size());
  std::iota(order.begin(), order.end(), 0U);
  tbb::parallel_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return keyOf(balls_[a]) < keyOf(balls_[b]); });
  std::vector<glm::vec4> sorted;
  sorted.reserve(balls_.size());
  std::vector<std::uint32_t> numbers(balls_.size());
  for (const std::uint32_t ball : order)
  {
    if (sorted.empty() || sorted.back() != balls_[ball])
    {
      sorted.push_back(balls_[ball]);
    }
    numbers[ball] = static_cast<std::uint32_t>(sorted.size() - 1);
  }
  balls_ = std::move(sorted);
  renumber(numbers, edges_);
  renumber(numbers, triangles_);
}

void BallFamilies::finish()
{
  this->sortBalls();
  sortUnique(edges_);
  sortUnique(triangles_);
  std::uint32_t triangle = 0;
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
  {
    const std::uint32_t ball = edges_[e][0];
    if (e == 0 || ball != edges_[e - 1][0])
    {
      items_.push_back({ e, triangle, 0.0f, 0.0f });
    }
    while (triangle < triangles_.size() && triangles_[triangle][0] == ball)
    {
      ++triangle;
    }
  }
  items_.push_back({ static_cast<std::uint32_t>(edges_.size()), triangle, 0.0f, 0.0f });
  std::vector<ItemBounds> bounds((this->itemCount() + kGroup - 1) / kGroup);
  tbb::parallel_for(std::size_t{ 0 }, bounds.size(),
    [&](std::size_t g)
    {
      const auto group = static_cast<std::uint32_t>(g);
      bounds[g] = ItemBounds::nothing();
      for (std::uint32_t i = this->firstItem(group); i < this->firstItem(group + 1); ++i)
      {
        bounds[g].add(this->measure(i));
      }
    });
  tree_ = std::make_unique<BoundingTree>(bounds);
}

} // namespace medial

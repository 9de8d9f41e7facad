#include "thickness/ball_families.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace medial
{
namespace
{

/// Sorts the ids of simplices and the simplices, and drops repeated ones.
template <typename Simplex>
void sortUnique(std::vector<Simplex>& simplices)
{
  tbb::parallel_for(std::size_t{ 0 }, simplices.size(),
    [&](std::size_t s) { std::sort(simplices[s].begin(), simplices[s].end()); });
  tbb::parallel_sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
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

ItemBounds BallFamilies::boundsOf(const Item& item) const
{
  // The corners of its triangles are ends of its edges.
  ItemBounds bounds = ItemBounds::nothing();
  for (std::uint32_t e = item.edgesBegin; e < item.edgesEnd; ++e)
  {
    for (const std::uint32_t id : edges_[e])
    {
      bounds.add(glm::dvec3(balls_[id]), static_cast<double>(balls_[id].w));
    }
  }
  return bounds;
}

void BallFamilies::finish()
{
  sortUnique(edges_);
  sortUnique(triangles_);
  std::uint32_t triangle = 0;
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
  {
    const std::uint32_t ball = edges_[e][0];
    if (e == 0 || ball != edges_[e - 1][0])
    {
      const std::uint32_t begin = triangle;
      while (triangle < triangles_.size() && triangles_[triangle][0] == ball)
      {
        ++triangle;
      }
      items_.push_back({ e, e, begin, triangle });
    }
    items_.back().edgesEnd = e + 1;
  }
  std::vector<ItemBounds> bounds(items_.size());
  tbb::parallel_for(std::size_t{ 0 }, items_.size(),
    [&](std::size_t i) { bounds[i] = this->boundsOf(items_[i]); });
  tree_ = std::make_unique<BoundingTree>(bounds);
}

} // namespace medial

#include "thickness/ball_families.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace medial
{
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
  const auto first = static_cast<std::uint32_t>(balls_.size());
  balls_.reserve(balls_.size() + axis.points.size());
  for (std::size_t p = 0; p < axis.points.size(); ++p)
  {
    const Point3& point = axis.points[p];
    this->add(glm::vec3((glm::dvec3(point[0], point[1], point[2]) - origin_) / unit_),
      static_cast<float>(static_cast<double>(axis.radius[p]) / unit_));
  }
  const auto joinPoints = [&](std::int64_t a, std::int64_t b)
  { this->join(first + static_cast<std::uint32_t>(a), first + static_cast<std::uint32_t>(b)); };
  const auto length = [&](std::int64_t a, std::int64_t b)
  {
    return glm::distance(glm::vec3(balls_[first + static_cast<std::size_t>(a)]),
      glm::vec3(balls_[first + static_cast<std::size_t>(b)]));
  };
  edges_.reserve(edges_.size() + 5 * axis.quads.size() + 3 * axis.triangles.size() +
    axis.lines.size() + axis.vertices.size());
  for (const auto& quad : axis.quads)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      joinPoints(quad[corner], quad[(corner + 1) % 4]);
    }
    const int diagonal = length(quad[0], quad[2]) <= length(quad[1], quad[3]) ? 0 : 1;
    joinPoints(quad[diagonal], quad[diagonal + 2]);
  }
  for (const auto& triangle : axis.triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      joinPoints(triangle[corner], triangle[(corner + 1) % 3]);
    }
  }
  for (const auto& line : axis.lines)
  {
    joinPoints(line[0], line[1]);
  }
  for (const std::int64_t vertex : axis.vertices)
  {
    joinPoints(vertex, vertex);
  }
}

ItemBounds BallFamilies::boundsOf(const Item& item) const
{
  ItemBounds bounds = ItemBounds::nothing();
  for (std::uint32_t e = item.first; e < item.end; ++e)
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
  tbb::parallel_for(std::size_t{ 0 }, edges_.size(),
    [&](std::size_t e) { std::sort(edges_[e].begin(), edges_[e].end()); });
  tbb::parallel_sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
  {
    if (e == 0 || edges_[e][0] != edges_[e - 1][0])
    {
      items_.push_back({ e, e });
    }
    items_.back().end = e + 1;
  }
  std::vector<ItemBounds> bounds(items_.size());
  tbb::parallel_for(std::size_t{ 0 }, items_.size(),
    [&](std::size_t i) { bounds[i] = this->boundsOf(items_[i]); });
  tree_ = std::make_unique<BoundingTree>(bounds);
}

} // namespace medial

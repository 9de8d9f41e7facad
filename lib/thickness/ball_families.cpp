#include "thickness/ball_families.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

constexpr int kTile = 8;
/// Tiles are larger where there would be more.
constexpr double kTilesPerBall = 4.0;
/// How often the middle of a ball around others is moved towards the one that sticks out most.
constexpr int kAroundRounds = 6;

/// Values in lists, one list for each of some keys.
template <typename Value>
struct Lists
{
  std::vector<std::uint32_t> begins; ///< and the end of the last
  std::vector<Value> values;
};

/// Sorts values into lists, and each list.
/// @param forEach calls what it is given with the key of each value and the value; called twice.
template <typename Value, typename ForEach, typename Less = std::less<>>
Lists<Value> sortedLists(std::size_t keys, const ForEach& forEach, const Less& less = {})
{
  Lists<Value> lists;
  lists.begins.resize(keys + 1);
  forEach([&](std::size_t key, const Value&) { ++lists.begins[key]; });
  std::partial_sum(lists.begins.begin(), lists.begins.end(), lists.begins.begin());
  lists.values.resize(lists.begins.back());
  forEach([&](std::size_t key, const Value& value)
    { lists.values[--lists.begins[key]] = value; }); // leaves where the list begins
  tbb::parallel_for(std::size_t{ 0 }, keys,
    [&](std::size_t key)
    {
      std::sort(lists.values.begin() + lists.begins[key],
        lists.values.begin() + lists.begins[key + 1], less);
    });
  return lists;
}

/// Drops repeated values from lists.
template <typename Value>
void dropRepeated(Lists<Value>& lists)
{
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  for (std::size_t key = 0; key + 1 < lists.begins.size(); ++key)
  {
    const std::uint32_t next = lists.begins[key + 1];
    lists.begins[key] = end;
    for (std::uint32_t v = begin; v < next; ++v)
    {
      if (end == lists.begins[key] || lists.values[end - 1] != lists.values[v])
      {
        lists.values[end++] = lists.values[v];
      }
    }
    begin = next;
  }
  lists.begins.back() = end;
  lists.values.resize(end);
  lists.values.shrink_to_fit();
}

/// Replaces the ids of simplices, and sorts those of each.
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
      std::sort(simplices[s].begin(), simplices[s].end());
    });
}

} // namespace

BallFamilies::BallFamilies(const Grid& grid, double angle)
  : unit_(*std::min_element(grid.spacing.begin(), grid.spacing.end()))
  , origin_(grid.origin[0], grid.origin[1], grid.origin[2])
  , places_(glm::dvec3(grid.spacing[0], grid.spacing[1], grid.spacing[2]) / unit_)
  , dimensions_(grid.dimensions)
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
  balls_.reserve(balls_.size() + axis.points.size());
  triangles_.reserve(triangles_.size() + 2 * axis.quads.size() + axis.triangles.size());
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
  balls_.reserve(balls_.size() + mesh.balls.size());
  triangles_.reserve(triangles_.size() + mesh.triangles.size());
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

void BallFamilies::joinQuad(const std::array<std::uint32_t, 4>& quad)
{
  const int from =
    this->length(quad[0], quad[2]) <= this->length(quad[1], quad[3]) ? 0 : 1; // of the diagonal
  this->joinTriangle({ quad[from], quad[from + 1], quad[from + 2] });
  this->joinTriangle({ quad[from], quad[from + 2], quad[(from + 3) % 4] });
}

/// Sorts the balls by tiles of the grid, so that neighbours are close together in memory, and
/// merges equal ones.
void BallFamilies::sortBalls()
{
  glm::ivec3 tiles;
  int size = kTile;
  do
  {
    tiles = (glm::ivec3(dimensions_[0], dimensions_[1], dimensions_[2]) - 1) / size + 1;
    size *= 2;
  } while (
    static_cast<double>(tiles.x) * tiles.y * tiles.z > kTilesPerBall * (balls_.size() + 1.0));
  const glm::vec3 perTile = 2.0f / (static_cast<float>(size) * places_.step);
  const auto tileOf = [&](const glm::vec4& ball)
  {
    const glm::ivec3 tile =
      glm::clamp(glm::ivec3(glm::vec3(ball) * perTile), glm::ivec3(0), tiles - 1);
    return (static_cast<std::size_t>(tile.z) * tiles.y + tile.y) * tiles.x + tile.x;
  };
  const auto placeOf = [&](std::uint32_t id)
  {
    const glm::vec4& ball = balls_[id];
    return std::make_tuple(ball.z, ball.y, ball.x, ball.w);
  };
  const Lists<std::uint32_t> ids = sortedLists<std::uint32_t>(
    static_cast<std::size_t>(tiles.x) * tiles.y * tiles.z,
    [&](const auto& visit)
    {
      for (std::uint32_t id = 0; id < balls_.size(); ++id)
      {
        visit(tileOf(balls_[id]), id);
      }
    },
    [&](std::uint32_t a, std::uint32_t b) { return placeOf(a) < placeOf(b); });
  std::vector<glm::vec4> sorted;
  std::vector<std::uint32_t> numbers(balls_.size());
  for (const std::uint32_t id : ids.values)
  {
    if (sorted.empty() || sorted.back() != balls_[id])
    {
      sorted.push_back(balls_[id]);
    }
    numbers[id] = static_cast<std::uint32_t>(sorted.size() - 1);
  }
  sorted.shrink_to_fit();
  balls_ = std::move(sorted);
  renumber(numbers, edges_);
  renumber(numbers, triangles_);
}

/// Makes items of the edges and triangles.
void BallFamilies::makeItems()
{
  Lists<Pair> triangles = sortedLists<Pair>(balls_.size(),
    [&](const auto& visit)
    {
      for (const auto& [a, b, c] : triangles_)
      {
        visit(a, Pair{ b, c });
      }
    });
  Lists<std::uint32_t> ends = sortedLists<std::uint32_t>(balls_.size(),
    [&](const auto& visit)
    {
      for (const auto& [a, b] : edges_)
      {
        visit(a, b);
      }
      for (const auto& [a, b, c] : triangles_)
      {
        visit(a, b);
        visit(a, c);
        visit(b, c);
      }
    });
  edges_ = {};
  triangles_ = {};
  dropRepeated(triangles);
  dropRepeated(ends);
  for (std::uint32_t ball = 0; ball < balls_.size(); ++ball)
  {
    if (ends.begins[ball] != ends.begins[ball + 1])
    {
      items_.push_back({ ball, ends.begins[ball], triangles.begins[ball] });
    }
  }
  items_.push_back({ 0, ends.begins.back(), triangles.begins.back() });
  edgeEnds_ = std::move(ends.values);
  triangleEnds_ = std::move(triangles.values);
}

/// Returns a ball around the families of an item, nearly the smallest.
glm::vec4 BallFamilies::ballAround(std::uint32_t number) const
{
  const glm::vec4& common = balls_[items_[number].ball];
  const auto distanceOf = [](const glm::vec3& from, const glm::vec4& ball)
  { return glm::distance(from, glm::vec3(ball)) + ball.w; };
  glm::vec3 middle(common);
  glm::vec4 best(middle, std::numeric_limits<float>::max());
  for (int round = 1; round <= kAroundRounds; ++round)
  {
    // How far a ball reaches is convex: none between two reaches farther.
    const glm::vec4* farthest = &common;
    float reach = distanceOf(middle, common);
    for (std::uint32_t e = items_[number].edgesBegin; e < items_[number + 1].edgesBegin; ++e)
    {
      const glm::vec4& ball = balls_[edgeEnds_[e]];
      const float distance = distanceOf(middle, ball);
      if (distance > reach)
      {
        reach = distance;
        farthest = &ball;
      }
    }
    if (reach < best.w)
    {
      best = glm::vec4(middle, reach);
    }
    middle += (glm::vec3(*farthest) - middle) / static_cast<float>(round + 1);
  }
  return best;
}

/// Sets what bounds an item in its group, and returns its bounds.
ItemBounds BallFamilies::measure(std::uint32_t number)
{
  const Item& item = items_[number];
  const Item& next = items_[number + 1];
  const glm::vec4& common = balls_[item.ball];
  ItemBounds bounds = ItemBounds::nothing();
  bounds.add(glm::dvec3(common), static_cast<double>(common.w));
  float longest = 0.0f;
  for (std::uint32_t e = item.edgesBegin; e < next.edgesBegin; ++e)
  {
    const glm::vec4& ball = balls_[edgeEnds_[e]];
    bounds.add(glm::dvec3(ball), static_cast<double>(ball.w));
    longest = std::max(longest, this->length(item.ball, edgeEnds_[e]));
  }
  for (std::uint32_t t = item.trianglesBegin; t < next.trianglesBegin; ++t)
  {
    longest = std::max(longest, this->length(triangleEnds_[t][0], triangleEnds_[t][1]));
  }
  BallGroup& group = groups_[number / kGroup];
  const std::uint32_t lane = number % kGroup;
  group.x[lane] = common.x;
  group.y[lane] = common.y;
  group.z[lane] = common.z;
  group.radius[lane] = common.w;
  const glm::vec4 around = this->ballAround(number);
  group.middleX[lane] = around.x;
  group.middleY[lane] = around.y;
  group.middleZ[lane] = around.z;
  group.span[lane] = around.w;
  group.length[lane] = longest;
  group.largest[lane] = static_cast<float>(bounds.reach);
  return bounds;
}

void BallFamilies::finish()
{
  this->sortBalls();
  this->makeItems();
  groups_.resize((this->itemCount() + kGroup - 1) / kGroup);
  std::vector<ItemBounds> bounds(groups_.size());
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

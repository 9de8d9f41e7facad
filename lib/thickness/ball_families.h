#pragma once

#include "axis/seams/ball_mesh.h"
#include "balls/bounding_tree.h"
#include "medial/grid.h"
#include "medial/medial_axis.h"
#include "thickness/tile_radii.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace medial
{

/// Inscribed balls whose centres fill edges and triangles, with a radius that is linear on each of
/// them. All lengths are in units of the grid's finest spacing; the origin is grid point (0,0,0).
class BallFamilies
{
public:
  /// Ids of two balls.
  using Pair = std::array<std::uint32_t, 2>;
  using Triangle = std::array<std::uint32_t, 3>;

  /// @param angle separation angle of the balls, radians.
  BallFamilies(const Grid& grid, double angle);

  /// Adds the cells of an axis, quads as two triangles, and the balls that they need.
  void add(const MedialAxis& axis);
  /// @param mesh world coordinates.
  void add(const BallMesh& mesh);
  /// Adds a ball; returns its id.
  std::uint32_t add(const glm::vec3& centre, float radius);
  /// Joins two balls by a family.
  void join(std::uint32_t first, std::uint32_t second) { edges_.push_back({ first, second }); }
  /// Joins four balls, in cyclic order, by the families of two triangles and their edges.
  void joinQuad(const std::array<std::uint32_t, 4>& quad);
  /// To be called once, after the last addition. Uses the threads of the current arena.
  void finish();

  double unit() const { return unit_; }
  const glm::vec3& step() const { return places_.step; } ///< between neighbouring grid points
  const TilePlaces& places() const { return places_; }   ///< of the grid points of a tile
  std::size_t size() const { return balls_.size(); }
  float maxRadius() const { return maxRadius_; }
  /// Balls with smaller separation angles lie within those of the families times this.
  float stretch() const { return stretch_; }
  /// Centre and radius.
  const glm::vec4& ball(std::uint32_t id) const { return balls_[id]; }

  /// The families of one ball, and of it with balls that have larger ids.
  struct Item
  {
    std::uint32_t ball;       ///< that all of them have in common
    std::uint32_t edgesBegin; ///< they end where the next item's begin
    std::uint32_t trianglesBegin;
  };
  std::uint32_t itemCount() const { return static_cast<std::uint32_t>(items_.size() - 1); }
  const Item& item(std::uint32_t number) const { return items_[number]; }
  /// The other balls of all items' edges.
  const std::vector<std::uint32_t>& edgeEnds() const { return edgeEnds_; }
  /// The other balls of all items' triangles.
  const std::vector<Pair>& triangleEnds() const { return triangleEnds_; }
  /// What bounds the items of a group; those that it lacks are nothing.
  const BallGroup& group(std::uint32_t number) const { return groups_[number]; }
  /// A tree of groups of items, which are close together: group g has the items from firstItem(g)
  /// to firstItem(g + 1).
  const BoundingTree& tree() const { return *tree_; }
  std::uint32_t firstItem(std::uint32_t group) const
  {
    return std::min(group * kGroup, this->itemCount());
  }

private:
  static constexpr std::uint32_t kGroup = kGroupBalls;

  void joinTriangle(const Triangle& triangle) { triangles_.push_back(triangle); }
  void sortBalls();
  void makeItems();
  glm::vec4 ballAround(std::uint32_t number) const;
  ItemBounds measure(std::uint32_t number);
  float length(std::uint32_t first, std::uint32_t second) const
  {
    return glm::distance(glm::vec3(balls_[first]), glm::vec3(balls_[second]));
  }

  double unit_;
  glm::dvec3 origin_;
  TilePlaces places_;
  std::array<int, 3> dimensions_;
  float stretch_;
  float maxRadius_ = 0.0f;
  std::vector<glm::vec4> balls_;
  std::vector<Pair> edges_;         ///< those without triangles, until finish()
  std::vector<Triangle> triangles_; ///< until finish()
  std::vector<Item> items_;         ///< with one behind the last
  std::vector<std::uint32_t> edgeEnds_;
  std::vector<Pair> triangleEnds_;
  std::vector<BallGroup> groups_;
  std::unique_ptr<BoundingTree> tree_;
};

} // namespace medial

#include "measure/coincident_parts.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Bounds of points without radii.
template <typename Points>
ItemBounds boundsOf(const Points& points)
{
  ItemBounds bounds = ItemBounds::nothing();
  for (const glm::dvec3& point : points)
  {
    bounds.add(point, 0.0);
  }
  return bounds;
}

} // namespace

CoincidentParts::CoincidentParts(const BallUnion& solid, const BallNeighbours& neighbours,
  double tolerance)
  : balls_(solid.balls())
  , neighbours_(neighbours)
  , tolerance_(tolerance)
  , wedges_(this->treeOfWedges())
  , cones_(this->treeOfCones())
  , centres_(this->treeOfBalls())
{
}

BoundingTree CoincidentParts::treeOfWedges() const
{
  std::vector<ItemBounds> items;
  items.reserve(2 * neighbours_.wedges().size());
  for (std::size_t wedge = 0; wedge < neighbours_.wedges().size(); ++wedge)
  {
    const auto& [a, b, c] = neighbours_.wedges()[wedge];
    const auto normals = tangentNormals(balls_[a], balls_[b], balls_[c]);
    for (int side = 0; side < 2; ++side)
    {
      // A wedge that no plane touches has no triangle; a point keeps its place in the list.
      items.push_back(normals ? boundsOf(this->touchingTriangle(wedge, (*normals)[side]))
                              : boundsOf(std::array{ balls_[a].centre }));
    }
  }
  return BoundingTree(items);
}

BoundingTree CoincidentParts::treeOfCones() const
{
  std::vector<ItemBounds> items;
  items.reserve(neighbours_.cones().size());
  for (const auto& [a, b] : neighbours_.cones())
  {
    items.push_back(boundsOf(std::array{ balls_[a].centre, balls_[b].centre }));
  }
  return BoundingTree(items);
}

BoundingTree CoincidentParts::treeOfBalls() const
{
  std::vector<ItemBounds> items;
  items.reserve(balls_.size());
  for (const Ball& ball : balls_)
  {
    items.push_back(boundsOf(std::array{ ball.centre }));
  }
  return BoundingTree(items);
}

template <typename Has>
bool CoincidentParts::any(const BoundingTree& tree, const glm::dvec3& place, const Has& has) const
{
  double limit = tolerance_;
  bool found = false;
  tree.search(place, limit,
    [&](std::uint32_t item)
    {
      if (!found && has(item))
      {
        found = true;
        limit = 0.0; // ends the search
      }
    });
  return found;
}

CoincidentParts::Triangle CoincidentParts::touchingTriangle(std::size_t wedge,
  const glm::dvec3& normal) const
{
  Triangle triangle;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Ball& ball = balls_[neighbours_.wedges()[wedge][corner]];
    triangle[corner] = ball.centre + ball.radius * normal;
  }
  return triangle;
}

bool CoincidentParts::wedgeTouches(std::size_t wedge, const glm::dvec3& place,
  const glm::dvec3& normal) const
{
  const auto& [a, b, c] = neighbours_.wedges()[wedge];
  const auto normals = tangentNormals(balls_[a], balls_[b], balls_[c]);
  return normals &&
    std::any_of(normals->begin(), normals->end(),
      [&](const glm::dvec3& own)
      {
        // Both sides of a wedge without thickness are on the boundary.
        if (!(glm::dot(own, normal) > 0.0))
        {
          return false;
        }
        const Triangle corners = this->touchingTriangle(wedge, own);
        if (!(std::abs(glm::dot(place - corners[0], own)) < tolerance_))
        {
          return false;
        }
        double least = 0.0;
        double most = 0.0;
        for (int i = 0; i < 3; ++i)
        {
          const glm::dvec3 side = corners[(i + 1) % 3] - corners[i];
          const double area = glm::dot(glm::cross(side, place - corners[i]), own);
          least = std::min(least, area);
          most = std::max(most, area);
        }
        return least >= 0.0 || most <= 0.0;
      });
}

bool CoincidentParts::onEarlierWedge(std::size_t wedge, const glm::dvec3& place,
  const glm::dvec3& normal) const
{
  return this->any(wedges_, place,
    [&](std::uint32_t item)
    { return item / 2 < wedge && this->wedgeTouches(item / 2, place, normal); });
}

bool CoincidentParts::coneHas(std::size_t cone, const Ball& ball, const glm::dvec3& normal) const
{
  const auto& [first, second] = neighbours_.cones()[cone];
  const Ball& a = balls_[first];
  const Ball& b = balls_[second];
  const glm::dvec3 along = b.centre - a.centre;
  const double growth = b.radius - a.radius;
  const double squared = glm::dot(along, along);
  if (!(squared > growth * growth))
  {
    return false; // it has no lateral surface
  }
  const double t = glm::dot(ball.centre - a.centre, along) / squared;
  return t >= 0.0 && t <= 1.0 && glm::distance(ball.centre, a.centre + t * along) < tolerance_ &&
    std::abs(ball.radius - (a.radius + t * growth)) < tolerance_ &&
    !neighbours_.coneHidden(cone, normal);
}

bool CoincidentParts::onEarlierCone(std::size_t cone, const Ball& ball,
  const glm::dvec3& normal) const
{
  return this->any(cones_, ball.centre,
    [&](std::uint32_t other) { return other < cone && this->coneHas(other, ball, normal); });
}

bool CoincidentParts::onEarlierBall(std::int32_t ball, const glm::dvec3& normal) const
{
  return this->any(centres_, balls_[ball].centre,
    [&](std::uint32_t item)
    {
      const auto other = static_cast<std::int32_t>(item);
      return other < ball && this->equal(other, ball) && !neighbours_.ballHidden(other, normal);
    });
}

bool CoincidentParts::isRepeated(std::int32_t ball) const
{
  return this->any(centres_, balls_[ball].centre,
    [&](std::uint32_t item)
    {
      const auto other = static_cast<std::int32_t>(item);
      return other < ball && this->equal(other, ball);
    });
}

bool CoincidentParts::equal(std::int32_t a, std::int32_t b) const
{
  return glm::distance(balls_[a].centre, balls_[b].centre) < tolerance_ &&
    std::abs(balls_[a].radius - balls_[b].radius) < tolerance_;
}

} // namespace medial

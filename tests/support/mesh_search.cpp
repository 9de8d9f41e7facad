#include "support/mesh_search.h"

#include "support/point_math.h"

#include <algorithm>
#include <cmath>

namespace medial::test
{

namespace
{

constexpr std::size_t kLeafTriangles = 4;
/// Makes up for rounding, which is many times less.
constexpr double kSlack = 1e-9;

/// The unit normal of a triangle; zero where it is not at least a thousandth as high as long.
Point3 reliableNormal(const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 normal = cross(minus(b, a), minus(c, a));
  const double area = length(normal);
  const double side = std::max({ length(minus(b, a)), length(minus(c, b)), length(minus(a, c)) });
  if (!(area > 1e-3 * side * side))
  {
    return {};
  }
  return { normal[0] / area, normal[1] / area, normal[2] / area };
}

} // namespace

MeshSearch::MeshSearch(const TriangleMesh& mesh)
  : mesh_(mesh)
{
  triangles_.reserve(mesh.triangles.size());
  for (std::size_t id = 0; id < mesh.triangles.size(); ++id)
  {
    triangles_.push_back(this->triangle(id));
  }
  if (!triangles_.empty())
  {
    this->build(0, triangles_.size());
  }
}

MeshSearch::Triangle MeshSearch::triangle(std::size_t id) const
{
  const auto& [i, j, k] = mesh_.triangles[id];
  const Point3& a = mesh_.points[i];
  const Point3& b = mesh_.points[j];
  const Point3& c = mesh_.points[k];
  Point3 centre{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    centre[axis] = a[axis] + ((b[axis] - a[axis]) + (c[axis] - a[axis])) / 3.0;
  }
  const double radius =
    std::max({ length(minus(a, centre)), length(minus(b, centre)), length(minus(c, centre)) });
  return { id, { centre, radius * (1.0 + kSlack) }, reliableNormal(a, b, c) };
}

MeshSearch::Ball MeshSearch::ballAround(std::size_t begin, std::size_t end) const
{
  Point3 lowest = triangles_[begin].ball.centre;
  Point3 highest = lowest;
  for (std::size_t t = begin; t < end; ++t)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      lowest[axis] = std::min(lowest[axis], triangles_[t].ball.centre[axis]);
      highest[axis] = std::max(highest[axis], triangles_[t].ball.centre[axis]);
    }
  }
  Ball ball{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    ball.centre[axis] = lowest[axis] + 0.5 * (highest[axis] - lowest[axis]);
  }
  for (std::size_t t = begin; t < end; ++t)
  {
    const double reach = length(minus(triangles_[t].ball.centre, ball.centre));
    ball.radius = std::max(ball.radius, (reach + triangles_[t].ball.radius) * (1.0 + kSlack));
  }
  return ball;
}

void MeshSearch::build(std::size_t begin, std::size_t end)
{
  const std::size_t node = nodes_.size();
  nodes_.push_back({ this->ballAround(begin, end), begin, end, 0 });
  if (end - begin <= kLeafTriangles)
  {
    return;
  }
  // Halves along the axis along which the centres are farthest apart.
  std::size_t longest = 0;
  double most = -1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] =
      std::minmax_element(triangles_.begin() + begin, triangles_.begin() + end,
        [axis](const Triangle& a, const Triangle& b)
        { return a.ball.centre[axis] < b.ball.centre[axis]; });
    const double extent = high->ball.centre[axis] - low->ball.centre[axis];
    if (extent > most)
    {
      most = extent;
      longest = axis;
    }
  }
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle,
    triangles_.begin() + end,
    [longest](const Triangle& a, const Triangle& b)
    { return a.ball.centre[longest] < b.ball.centre[longest]; });
  this->build(begin, middle);
  nodes_[node].second = nodes_.size();
  this->build(middle, end);
}

Hit MeshSearch::closest(const Point3& query) const
{
  Hit best = closestOnSegmentsAndVertices(mesh_, query);
  if (!nodes_.empty())
  {
    this->search(nodes_.front(), query, best);
  }
  return best;
}

void MeshSearch::search(const Node& node, const Point3& query, Hit& best) const
{
  if (node.second == 0)
  {
    this->searchLeaf(node, query, best);
    return;
  }
  const std::size_t first = static_cast<std::size_t>(&node - nodes_.data()) + 1;
  struct Child
  {
    std::size_t node;
    double nearest;
  };
  const auto child = [&](std::size_t i) -> Child {
    return { i, length(minus(query, nodes_[i].ball.centre)) - nodes_[i].ball.radius };
  };
  Child nearer = child(first);
  Child farther = child(node.second);
  if (farther.nearest < nearer.nearest)
  {
    std::swap(nearer, farther);
  }
  for (const Child& next : { nearer, farther })
  {
    const double slack = kSlack * (best.distance + nodes_[next.node].ball.radius);
    if (next.nearest <= best.distance + slack)
    {
      this->search(nodes_[next.node], query, best);
    }
  }
}

void MeshSearch::searchLeaf(const Node& leaf, const Point3& query, Hit& best) const
{
  for (std::size_t t = leaf.begin; t < leaf.end; ++t)
  {
    const Triangle& triangle = triangles_[t];
    const Point3 toCentre = minus(query, triangle.ball.centre);
    const double reach = best.distance + triangle.ball.radius;
    if (dot(toCentre, toCentre) > reach * reach * (1.0 + kSlack))
    {
      continue;
    }
    const auto& [i, j, k] = mesh_.triangles[triangle.id];
    const Point3& corner = mesh_.points[i];
    // From a corner, as the centre is rounded.
    const double toPlane = std::abs(dot(minus(query, corner), triangle.normal));
    if (toPlane <= best.distance + kSlack * reach)
    {
      keepCloser(best, closestOnTriangle(corner, mesh_.points[j], mesh_.points[k], query));
    }
  }
}

} // namespace medial::test

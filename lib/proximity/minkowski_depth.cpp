#include "proximity/minkowski_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// What counts as nothing, as a share of the size of the meshes.
constexpr double kRounding = 1e-13;
constexpr int kMaxExpansions = 400;

/// Returns the point of a mesh that is farthest along a direction.
glm::dvec3 farthestPoint(const MovingMesh& mesh, const glm::dvec3& direction)
{
  struct Pending
  {
    int node;
    double max;
  };
  const auto& nodes = mesh.tree().nodes();
  const auto bound = [&](int node)
  {
    const glm::dvec3 low = nodes[node].box.min * direction;
    const glm::dvec3 high = nodes[node].box.max * direction;
    return std::max(low.x, high.x) + std::max(low.y, high.y) + std::max(low.z, high.z);
  };
  std::array<Pending, 64> stack;
  int count = 0;
  stack[count++] = { 0, std::numeric_limits<double>::infinity() };
  double max = -std::numeric_limits<double>::infinity();
  glm::dvec3 farthest(0.0);
  while (count > 0)
  {
    const Pending next = stack[--count];
    if (next.max <= max)
    {
      continue;
    }
    const BoxTree::Node& node = nodes[next.node];
    if (!node.leaf())
    {
      Pending more{ next.node + 1, bound(next.node + 1) };
      Pending less{ node.second, bound(node.second) };
      if (less.max > more.max)
      {
        std::swap(less, more);
      }
      stack[count++] = less;
      stack[count++] = more;
      continue;
    }
    for (int slot = node.first; slot < node.first + node.count; ++slot)
    {
      for (const glm::dvec3& corner : mesh.element(slot).corners)
      {
        const double along = glm::dot(corner, direction);
        if (along > max)
        {
          max = along;
          farthest = corner;
        }
      }
    }
  }
  return farthest;
}

/// The plane of a triangle, as it counts for the solid.
struct FacePlane
{
  FacePlane(const MovingMesh& mesh, int slot)
    : point(mesh.element(slot).corners[0])
  {
    const auto& [a, b, c] = mesh.element(slot).corners;
    const glm::dvec3 across = glm::cross(b - a, c - a) * static_cast<double>(mesh.weight(slot));
    const double length = glm::length(across);
    normal = length > 0.0 ? across / length : glm::dvec3(0.0);
  }

  double height(const glm::dvec3& x) const { return glm::dot(normal, x - point); }

  glm::dvec3 point;
  glm::dvec3 normal;
};

/// Whether no neighbour of a triangle is above its plane, roughly: that is quick, and no proof.
bool looksConvex(const MovingMesh& mesh, double tolerance)
{
  const MeshConnectivity& connectivity = mesh.connectivity();
  for (int edge = 0; edge < connectivity.edgeTriangles.rows(); ++edge)
  {
    if (connectivity.edgeTriangles.size(edge) != 2)
    {
      return false;
    }
    const int* const sides = connectivity.edgeTriangles.begin(edge);
    const FacePlane plane(mesh, mesh.slotOf(sides[0]));
    for (const int corner : mesh.mesh().triangles[sides[1]])
    {
      if (plane.height(mesh.points()[corner]) > tolerance)
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

glm::dvec3 MinkowskiDepth::support(const glm::dvec3& direction)
{
  const glm::dvec3 point = farthestPoint(b_, direction) - farthestPoint(a_, -direction);
  const double along = std::max(0.0, glm::dot(point, direction));
  if (best_.direction == glm::dvec3(0.0) || along < best_.upper)
  {
    best_.upper = along;
    best_.direction = direction;
  }
  return point;
}

MinkowskiDepth::Face MinkowskiDepth::faceOf(const std::array<int, 3>& corners) const
{
  const glm::dvec3& p = points_[corners[0]];
  const glm::dvec3 normal = glm::cross(points_[corners[1]] - p, points_[corners[2]] - p);
  const double length = glm::length(normal);
  const glm::dvec3 unit = length > 0.0 ? normal / length : glm::dvec3(0.0);
  return { corners, unit, glm::dot(unit, p) };
}

template <typename Height>
bool MinkowskiDepth::addFarthest(std::initializer_list<glm::dvec3> directions, const Height& height)
{
  double max = tolerance_;
  glm::dvec3 farthest(0.0);
  for (const glm::dvec3& direction : directions)
  {
    const glm::dvec3 point = this->support(direction);
    if (height(point) > max)
    {
      max = height(point);
      farthest = point;
    }
  }
  points_.push_back(farthest);
  return max > tolerance_;
}

bool MinkowskiDepth::begin()
{
  const glm::dvec3 x(1.0, 0.0, 0.0);
  points_ = { this->support(x), this->support(-x) };
  const glm::dvec3 along = points_[0] - points_[1];
  if (glm::length(along) <= tolerance_)
  {
    return false;
  }
  const glm::dvec3 axis =
    std::abs(along.y) < std::abs(along.z) ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 across = glm::normalize(glm::cross(along, axis));
  const glm::dvec3 third = glm::normalize(glm::cross(along, across));
  if (!this->addFarthest({ across, -across, third, -third },
        [&](const glm::dvec3& point)
        { return glm::length(glm::cross(point - points_[0], glm::normalize(along))); }))
  {
    return false;
  }
  const glm::dvec3 normal = glm::normalize(glm::cross(along, points_[2] - points_[0]));
  if (!this->addFarthest({ normal, -normal },
        [&](const glm::dvec3& point) { return std::abs(glm::dot(point - points_[0], normal)); }))
  {
    return false;
  }
  for (const std::array<int, 3>& corners :
    { std::array{ 0, 1, 2 }, std::array{ 0, 1, 3 }, std::array{ 0, 2, 3 }, std::array{ 1, 2, 3 } })
  {
    const int other = 6 - corners[0] - corners[1] - corners[2];
    Face face = this->faceOf(corners);
    if (glm::dot(face.normal, points_[other]) > face.distance)
    {
      face = this->faceOf({ corners[0], corners[2], corners[1] });
    }
    faces_.push_back(face);
  }
  return true;
}

bool MinkowskiDepth::expand(const glm::dvec3& corner)
{
  edges_.clear();
  const auto visible = std::partition(faces_.begin(), faces_.end(),
    [&](const Face& face)
    { return glm::dot(face.normal, corner) - face.distance <= 0.5 * tolerance_; });
  for (auto face = visible; face != faces_.end(); ++face)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::pair<int, int> edge{ face->corners[i], face->corners[(i + 1) % 3] };
      const auto twin = std::find(edges_.begin(), edges_.end(), std::pair(edge.second, edge.first));
      if (twin != edges_.end())
      {
        edges_.erase(twin);
        continue;
      }
      edges_.push_back(edge);
    }
  }
  if (visible == faces_.end())
  {
    return false;
  }
  faces_.erase(visible, faces_.end());
  const int added = static_cast<int>(points_.size());
  points_.push_back(corner);
  for (const auto& [from, to] : edges_)
  {
    faces_.push_back(this->faceOf({ from, to, added }));
    if (faces_.back().normal == glm::dvec3(0.0))
    {
      return false;
    }
  }
  return true;
}

HullDepth MinkowskiDepth::find()
{
  tolerance_ =
    kRounding * (glm::length(a_.tree().box().size()) + glm::length(b_.tree().box().size()));
  best_ = {};
  faces_.clear();
  if (!this->begin())
  {
    return best_; // flat: it has no inside
  }
  for (int i = 0; i < kMaxExpansions; ++i)
  {
    const Face nearest = *std::min_element(faces_.begin(), faces_.end(),
      [](const Face& p, const Face& q) { return p.distance < q.distance; });
    best_.lower = std::max(best_.lower, std::min(nearest.distance, best_.upper));
    const glm::dvec3 next = this->support(nearest.normal);
    if (glm::dot(next, nearest.normal) - nearest.distance <= tolerance_ || !this->expand(next))
    {
      break;
    }
  }
  return best_;
}

bool isConvex(const MovingMesh& mesh)
{
  constexpr double kFlat = 2e-10;
  const double tolerance = kFlat * glm::length(mesh.tree().box().size());
  if (!mesh.closed() || mesh.componentPoints().size() != 1 || !looksConvex(mesh, tolerance))
  {
    return false;
  }
  for (int slot = 0; slot < mesh.size(); ++slot)
  {
    const FacePlane plane(mesh, slot);
    if (plane.height(farthestPoint(mesh, plane.normal)) > tolerance)
    {
      return false;
    }
  }
  return true;
}

} // namespace medial

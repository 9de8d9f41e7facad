#include "soft_body.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace
{

// Of a point of mass 1.
constexpr double kEdgeStiffness = 400.0;
constexpr double kShapeStiffness = 60.0;
constexpr double kDamping = 2.0; ///< of motion within the body, for a second

Point3 mean(const std::vector<Point3>& vectors)
{
  Point3 sum{};
  for (const Point3& vector : vectors)
  {
    sum = sum + vector;
  }
  return (1.0 / static_cast<double>(vectors.size())) * sum;
}

} // namespace

Point3 operator+(const Point3& a, const Point3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Point3 operator-(const Point3& a, const Point3& b)
{
  return a + -1.0 * b;
}

Point3 operator*(double factor, const Point3& a)
{
  return { factor * a[0], factor * a[1], factor * a[2] };
}

double dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const Point3& a)
{
  return std::sqrt(dot(a, a));
}

SoftBody::SoftBody(medial::TriangleMesh mesh, const Point3& velocity)
  : mesh_(std::move(mesh))
  , rest_(mesh_.points)
  , velocities_(rest_.size(), velocity)
  , forces_(rest_.size())
{
  const Point3 centre = mean(rest_);
  for (Point3& point : rest_)
  {
    point = point - centre;
  }
  std::set<std::array<int, 2>> edges;
  for (const auto& [a, b, c] : mesh_.triangles)
  {
    for (const auto& [from, to] : { std::array{ a, b }, std::array{ b, c }, std::array{ c, a } })
    {
      edges.insert({ std::min(from, to), std::max(from, to) });
    }
  }
  for (const auto& edge : edges)
  {
    springs_.push_back({ edge, length(rest_[edge[1]] - rest_[edge[0]]) });
  }
}

void SoftBody::addSprings()
{
  const std::vector<Point3>& points = mesh_.points;
  for (const auto& [ends, restLength] : springs_)
  {
    const Point3 along = points[ends[1]] - points[ends[0]];
    const double now = length(along);
    if (now > 0.0)
    {
      const Point3 force = kEdgeStiffness * (now - restLength) / now * along;
      this->addForce(ends[0], force);
      this->addForce(ends[1], -1.0 * force);
    }
  }
  const Point3 centre = mean(points);
  const Point3 drift = mean(velocities_);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point3 stretch = centre + rest_[i] - points[i];
    this->addForce(static_cast<int>(i),
      kShapeStiffness * stretch - kDamping * (velocities_[i] - drift));
  }
}

void SoftBody::step(double seconds)
{
  this->addSprings();
  for (std::size_t i = 0; i < mesh_.points.size(); ++i)
  {
    velocities_[i] = velocities_[i] + seconds * forces_[i];
    mesh_.points[i] = mesh_.points[i] + seconds * velocities_[i];
    forces_[i] = {};
  }
}

#include "simplification/boundary_planes.h"

#include "balls/ball_tree.h"
#include "simplification/wedge.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

constexpr double kPi = 3.14159265358979323846;
constexpr int kArcSamples = 6;
constexpr int kCircleSamples = 12;
constexpr int kSphereSamples = 32;
constexpr double kTipCosine = 0.5; ///< of the angle between neighbours and their mean direction
/// A boundary point is covered where another ball reaches beyond it by this share of the mean
/// length of edges, that is of the grid's spacing: far above rounding, below any hole.
constexpr double kCoverDepth = 0.05;

/// Closest points nearer than this (units of the axis) give no direction in single precision.
constexpr double kMinRadius = 1e-4;

double areaOf(const Ball& a, const Ball& b, const Ball& c)
{
  return 0.5 * glm::length(glm::cross(centreOf(b) - centreOf(a), centreOf(c) - centreOf(a)));
}

double meanLength(const std::vector<Ball>& balls, const BallComplex& complex)
{
  double sum = 0.0;
  const std::vector<int> edges = complex.edges();
  for (const int edge : edges)
  {
    const auto [a, b] = complex.edge(edge);
    sum += glm::distance(centreOf(balls[a]), centreOf(balls[b]));
  }
  return edges.empty() ? 0.0 : sum / static_cast<double>(edges.size());
}

using Planes = std::vector<TangentPlane>;

class Gatherer
{
public:
  Gatherer(const std::vector<Ball>& balls, const std::vector<Contacts>& contacts,
    const BallComplex& complex)
    : balls_(balls)
    , contacts_(contacts)
    , complex_(complex)
    , tree_(balls)
    , depth_(kCoverDepth * meanLength(balls, complex))
  {
  }

  /// The share of a vertex in the cells around it.
  Planes at(int vertex) const
  {
    Planes planes;
    if (!contacts_.empty())
    {
      this->addContacts(vertex, planes);
    }
    else
    {
      for (const int triangle : complex_.trianglesOf(vertex))
      {
        this->addSlab(vertex, complex_.triangle(triangle), planes);
      }
    }
    for (const int edge : complex_.edgesOf(vertex))
    {
      this->addEdge(vertex, edge, planes);
    }
    if (this->isTip(vertex))
    {
      this->addSphere(vertex, planes);
    }
    return planes;
  }

private:
  /// Both planes, each for a third of the area in which the slab's face meets it.
  void addSlab(int vertex, const std::array<int, 3>& corners, Planes& planes) const
  {
    const auto slab = slabOf(balls_[corners[0]], balls_[corners[1]], balls_[corners[2]]);
    if (slab)
    {
      const double weight = slab->area * slab->sine / 3.0;
      const Ball& ball = balls_[vertex];
      for (const glm::dvec3& normal : { slab->normal(1.0), slab->normal(-1.0) })
      {
        if (!tree_.covers(centreOf(ball) + ball.w * normal, depth_))
        {
          this->addTangent(vertex, normal, weight, planes);
        }
      }
    }
  }

  /// The planes that touch the surface where the ball does.
  void addContacts(int vertex, Planes& planes) const
  {
    double area = 0.0;
    for (const int triangle : complex_.trianglesOf(vertex))
    {
      const auto& [a, b, c] = complex_.triangle(triangle);
      area += areaOf(balls_[a], balls_[b], balls_[c]) / 3.0;
    }
    const glm::dvec3 centre = centreOf(balls_[vertex]);
    const glm::dvec3 toA = contacts_[vertex][0] - centre;
    const glm::dvec3 toB = contacts_[vertex][1] - centre;
    const double lengthA = glm::length(toA);
    const double lengthB = glm::length(toB);
    if (area > 0.0 && std::min(lengthA, lengthB) > kMinRadius)
    {
      const double cosine = glm::dot(toA / lengthA, toB / lengthB);
      const double sineOfHalf = std::sqrt(std::max(0.0, 0.5 * (1.0 - cosine)));
      planes.push_back({ contacts_[vertex][0], toA / lengthA, area * sineOfHalf, vertex });
      planes.push_back({ contacts_[vertex][1], toB / lengthB, area * sineOfHalf, vertex });
    }
  }

  void addTangent(int vertex, const glm::dvec3& normal, double weight, Planes& planes) const
  {
    const Ball& ball = balls_[vertex];
    planes.push_back({ centreOf(ball) + ball.w * normal, normal, weight, vertex });
  }

  void addEdge(int vertex, int edge, Planes& planes) const
  {
    const auto [a, b] = complex_.edge(edge);
    const auto cone = coneOf(balls_[a], balls_[b]);
    const std::vector<int> opposite = complex_.opposite(edge);
    if (!cone || opposite.size() > 1)
    {
      return;
    }
    if (opposite.empty())
    {
      const glm::dvec3 side = anyPerpendicular(cone->axis);
      this->addArc(vertex, edge, *cone, side, kPi, kCircleSamples, planes);
      return;
    }
    const auto slab = slabOf(balls_[a], balls_[b], balls_[opposite[0]]);
    if (slab)
    {
      const glm::dvec3 inwards = centreOf(balls_[opposite[0]]) - centreOf(balls_[a]);
      const glm::dvec3 across = inwards - glm::dot(inwards, cone->axis) * cone->axis;
      const glm::dvec3 outwards = -glm::normalize(across);
      const double half = std::atan2(slab->sine, glm::dot(slab->slope, outwards));
      this->addArc(vertex, edge, *cone, outwards, half, kArcSamples, planes);
    }
  }

  /// Half the cone's boundary, from -halfAngle to halfAngle around its axis; 0 is `side`.
  void addArc(int vertex, int edge, const Cone& cone, const glm::dvec3& side, double halfAngle,
    int samples, Planes& planes) const
  {
    const auto [a, b] = complex_.edge(edge);
    const Ball middle = 0.5 * (balls_[a] + balls_[b]);
    const double step = 2.0 * halfAngle / samples;
    const double weight = 0.5 * cone.length * cone.sine * cone.sine * balls_[vertex].w * step;
    const glm::dvec3 other = glm::cross(cone.axis, side);
    for (int i = 0; i < samples; ++i)
    {
      const double angle = (i + 0.5) * step - halfAngle;
      const glm::dvec3 radial = std::cos(angle) * side + std::sin(angle) * other;
      const glm::dvec3 normal = cone.slope * cone.axis + cone.sine * radial;
      if (!tree_.covers(centreOf(middle) + middle.w * normal, depth_))
      {
        this->addTangent(vertex, normal, weight, planes);
      }
    }
  }

  /// Whether all neighbours lie to one side, as of the end of a line or the corner of a sheet.
  bool isTip(int vertex) const
  {
    std::vector<glm::dvec3> directions;
    glm::dvec3 sum(0.0);
    for (const int edge : complex_.edgesOf(vertex))
    {
      const glm::dvec3 to = centreOf(balls_[complex_.across(edge, vertex)]);
      const glm::dvec3 offset = to - centreOf(balls_[vertex]);
      const double length = glm::length(offset);
      directions.push_back(length > 0.0 ? offset / length : offset);
      sum += directions.back();
    }
    const double min = kTipCosine * glm::length(sum);
    return std::all_of(directions.begin(), directions.end(),
      [&](const glm::dvec3& direction) { return glm::dot(direction, sum) >= min; });
  }

  /// Directions along a spiral, each for the same area.
  void addSphere(int vertex, Planes& planes) const
  {
    const Ball& ball = balls_[vertex];
    const double weight = 4.0 * kPi * ball.w * ball.w / kSphereSamples;
    const double golden = kPi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < kSphereSamples; ++i)
    {
      const double z = 1.0 - (2.0 * i + 1.0) / kSphereSamples;
      const double rho = std::sqrt(1.0 - z * z);
      const glm::dvec3 normal(rho * std::cos(golden * i), rho * std::sin(golden * i), z);
      if (this->isOutermost(vertex, normal) &&
        !tree_.covers(centreOf(ball) + ball.w * normal, depth_))
      {
        this->addTangent(vertex, normal, weight, planes);
      }
    }
  }

  /// Whether the cells around the vertex leave its ball's boundary free in this direction.
  bool isOutermost(int vertex, const glm::dvec3& normal) const
  {
    const Ball direction(normal, 1.0);
    const auto& edges = complex_.edgesOf(vertex);
    return std::all_of(edges.begin(), edges.end(),
      [&](int edge)
      {
        const Ball& other = balls_[complex_.across(edge, vertex)];
        return glm::dot(direction, other - balls_[vertex]) <= 0.0;
      });
  }

  const std::vector<Ball>& balls_;
  const std::vector<Contacts>& contacts_;
  const BallComplex& complex_;
  BallTree tree_;
  double depth_;
};

} // namespace

std::vector<TangentPlane> boundaryPlanes(const std::vector<Ball>& balls,
  const std::vector<Contacts>& contacts, const BallComplex& complex)
{
  const Gatherer gatherer(balls, contacts, complex);
  std::vector<Planes> perVertex(balls.size());
  tbb::parallel_for(0, complex.vertexCount(),
    [&](int vertex) { perVertex[vertex] = gatherer.at(vertex); });
  Planes all;
  for (const Planes& planes : perVertex)
  {
    all.insert(all.end(), planes.begin(), planes.end());
  }
  return all;
}

} // namespace medial

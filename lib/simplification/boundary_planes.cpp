#include "simplification/boundary_planes.h"

#include "balls/ball_hulls.h"
#include "balls/ball_union.h"
#include "base/vectors.h"

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
constexpr int kBallSamples = 32;
constexpr double kTipCosine = 0.5; ///< of the angle between neighbours and their mean direction
/// A boundary point is covered if another ball extends beyond it by this share of the mean length
/// of edges, that is of the grid's spacing: far above rounding, and below any hole.
constexpr double kCoverDepth = 0.05;

/// Closest points nearer than this (units of the axis) give no direction in single precision.
constexpr double kMinRadius = 1e-4;

double areaOf(const Ball& a, const Ball& b, const Ball& c)
{
  return 0.5 * glm::length(glm::cross(b.centre - a.centre, c.centre - a.centre));
}

double meanLength(const std::vector<Ball>& balls, const BallComplex& complex)
{
  double sum = 0.0;
  const std::vector<int> edges = complex.edges();
  for (const int edge : edges)
  {
    const auto [a, b] = complex.edge(edge);
    sum += glm::distance(balls[a].centre, balls[b].centre);
  }
  return edges.empty() ? 0.0 : sum / static_cast<double>(edges.size());
}

using Planes = std::vector<TangentPlane>;

class Gatherer
{
public:
  Gatherer(const std::vector<Ball>& balls, const std::vector<ClosestPair>& pairs,
    const BallComplex& complex)
    : balls_(balls)
    , pairs_(pairs)
    , complex_(complex)
    , union_(balls)
    , depth_(kCoverDepth * meanLength(balls, complex))
  {
  }

  /// Returns the planes of a vertex from the cells around it.
  Planes at(int vertex) const
  {
    Planes planes;
    if (!pairs_.empty())
    {
      this->addClosestPair(vertex, planes);
    }
    else
    {
      for (const int triangle : complex_.trianglesOf(vertex))
      {
        this->addWedge(vertex, complex_.triangle(triangle), planes);
      }
    }
    for (const int edge : complex_.edgesOf(vertex))
    {
      this->addEdge(vertex, edge, planes);
    }
    if (this->isTip(vertex))
    {
      this->addBall(vertex, planes);
    }
    return planes;
  }

private:
  /// Adds both planes, each for a third of the area of its face of the wedge.
  void addWedge(int vertex, const std::array<int, 3>& corners, Planes& planes) const
  {
    const auto wedge = wedgeOf(balls_[corners[0]], balls_[corners[1]], balls_[corners[2]]);
    if (wedge)
    {
      const double weight = wedge->area * wedge->sine / 3.0;
      const Ball& ball = balls_[vertex];
      for (const glm::dvec3& normal : { wedge->normal(1.0), wedge->normal(-1.0) })
      {
        if (!union_.covers(ball.centre + ball.radius * normal, depth_))
        {
          this->addTangent(vertex, normal, weight, planes);
        }
      }
    }
  }

  /// Adds the planes that touch the surface where the ball does.
  void addClosestPair(int vertex, Planes& planes) const
  {
    double area = 0.0;
    for (const int triangle : complex_.trianglesOf(vertex))
    {
      const auto& [a, b, c] = complex_.triangle(triangle);
      area += areaOf(balls_[a], balls_[b], balls_[c]) / 3.0;
    }
    const glm::dvec3 centre = balls_[vertex].centre;
    const glm::dvec3 toA = pairs_[vertex][0] - centre;
    const glm::dvec3 toB = pairs_[vertex][1] - centre;
    const double lengthA = glm::length(toA);
    const double lengthB = glm::length(toB);
    if (area > 0.0 && std::min(lengthA, lengthB) > kMinRadius)
    {
      const double cosine = glm::dot(toA / lengthA, toB / lengthB);
      const double sineOfHalf = std::sqrt(std::max(0.0, 0.5 * (1.0 - cosine)));
      planes.push_back({ pairs_[vertex][0], toA / lengthA, area * sineOfHalf, vertex });
      planes.push_back({ pairs_[vertex][1], toB / lengthB, area * sineOfHalf, vertex });
    }
  }

  void addTangent(int vertex, const glm::dvec3& normal, double weight, Planes& planes) const
  {
    const Ball& ball = balls_[vertex];
    planes.push_back({ ball.centre + ball.radius * normal, normal, weight, vertex });
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
      const glm::dvec3 start = normalsTo(cone->axis)[0];
      this->addArc(vertex, edge, *cone, start, kPi, kCircleSamples, planes);
      return;
    }
    const auto wedge = wedgeOf(balls_[a], balls_[b], balls_[opposite[0]]);
    if (wedge)
    {
      const glm::dvec3 inwards = balls_[opposite[0]].centre - balls_[a].centre;
      const glm::dvec3 across = inwards - glm::dot(inwards, cone->axis) * cone->axis;
      const glm::dvec3 outwards = -glm::normalize(across);
      const double half = std::atan2(wedge->sine, glm::dot(wedge->slope, outwards));
      this->addArc(vertex, edge, *cone, outwards, half, kArcSamples, planes);
    }
  }

  /// Adds half the boundary of a cone, from -halfAngle to halfAngle around its axis; 0 is `start`.
  void addArc(int vertex, int edge, const Cone& cone, const glm::dvec3& start, double halfAngle,
    int samples, Planes& planes) const
  {
    const auto [a, b] = complex_.edge(edge);
    const Ball middle = toBall(0.5 * (toVector(balls_[a]) + toVector(balls_[b])));
    const double step = 2.0 * halfAngle / samples;
    const double weight = 0.5 * cone.length * cone.sine * cone.sine * balls_[vertex].radius * step;
    const glm::dvec3 other = glm::cross(cone.axis, start);
    for (int i = 0; i < samples; ++i)
    {
      const double angle = (i + 0.5) * step - halfAngle;
      const glm::dvec3 radial = std::cos(angle) * start + std::sin(angle) * other;
      const glm::dvec3 normal = cone.slope * cone.axis + cone.sine * radial;
      if (!union_.covers(middle.centre + middle.radius * normal, depth_))
      {
        this->addTangent(vertex, normal, weight, planes);
      }
    }
  }

  /// Whether all neighbours lie in one direction, as at the end of a line or the corner of a sheet.
  bool isTip(int vertex) const
  {
    std::vector<glm::dvec3> directions;
    glm::dvec3 sum(0.0);
    for (const int edge : complex_.edgesOf(vertex))
    {
      const glm::dvec3 to = balls_[complex_.across(edge, vertex)].centre;
      const glm::dvec3 offset = to - balls_[vertex].centre;
      const double length = glm::length(offset);
      directions.push_back(length > 0.0 ? offset / length : offset);
      sum += directions.back();
    }
    const double min = kTipCosine * glm::length(sum);
    return std::all_of(directions.begin(), directions.end(),
      [&](const glm::dvec3& direction) { return glm::dot(direction, sum) >= min; });
  }

  /// Adds directions along a spiral, each for the same area.
  void addBall(int vertex, Planes& planes) const
  {
    const Ball& ball = balls_[vertex];
    const double weight = 4.0 * kPi * ball.radius * ball.radius / kBallSamples;
    const double golden = kPi * (3.0 - std::sqrt(5.0));
    for (int i = 0; i < kBallSamples; ++i)
    {
      const double z = 1.0 - (2.0 * i + 1.0) / kBallSamples;
      const double rho = std::sqrt(1.0 - z * z);
      const glm::dvec3 normal(rho * std::cos(golden * i), rho * std::sin(golden * i), z);
      if (this->isOutermost(vertex, normal) &&
        !union_.covers(ball.centre + ball.radius * normal, depth_))
      {
        this->addTangent(vertex, normal, weight, planes);
      }
    }
  }

  /// Whether the cells around the vertex leave the boundary of its ball uncovered in this
  /// direction.
  bool isOutermost(int vertex, const glm::dvec3& normal) const
  {
    const glm::dvec4 direction(normal, 1.0);
    const auto& edges = complex_.edgesOf(vertex);
    return std::all_of(edges.begin(), edges.end(),
      [&](int edge)
      {
        const Ball& other = balls_[complex_.across(edge, vertex)];
        return glm::dot(direction, toVector(other) - toVector(balls_[vertex])) <= 0.0;
      });
  }

  const std::vector<Ball>& balls_;
  const std::vector<ClosestPair>& pairs_;
  const BallComplex& complex_;
  BallUnion union_;
  double depth_;
};

} // namespace

std::vector<TangentPlane> boundaryPlanes(const std::vector<Ball>& balls,
  const std::vector<ClosestPair>& pairs, const BallComplex& complex)
{
  const Gatherer gatherer(balls, pairs, complex);
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

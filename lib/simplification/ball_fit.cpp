#include "simplification/ball_fit.h"

#include "simplification/ball_quadric.h"
#include "simplification/model_distance.h"
#include "simplification/triangle_shape.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace medial
{
namespace
{

constexpr int kSteps = 12;
constexpr int kSolverSteps = 60;
constexpr double kSolverTolerance = 1e-3;
/// Damping relative to the weight of the points of a ball. It holds balls where the points leave
/// them free.
constexpr double kDamping = 0.1;
/// Weight of the quadrics of the balls themselves. Without them balls grow beyond the surface where
/// no point is near.
constexpr double kOwn = 0.1;
constexpr double kMinDamping = 1e-12;
/// This many points per ball are enough, and at least this many in all.
constexpr std::size_t kPointsPerBall = 100;
constexpr std::size_t kMinPoints = 20000;
/// Below this mean distance (units of the axis) there is nothing left to improve.
constexpr double kExact = 3e-5;
/// A step that reduces the sum of squares by less than this share is the last one.
constexpr double kGain = 0.01;

/// One vector of R^4 per ball.
using Vectors = std::vector<glm::dvec4>;

double dot(const Vectors& a, const Vectors& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += glm::dot(a[i], b[i]);
  }
  return sum;
}

/// Solves by conjugate gradients from 0, with the diagonal as preconditioner.
template <typename Apply>
Vectors solveConjugate(const Apply& apply, const Vectors& diagonal, Vectors residual)
{
  Vectors x(residual.size(), glm::dvec4(0.0));
  Vectors search;
  double last = 1.0;
  double first = 0.0;
  for (int step = 0; step < kSolverSteps; ++step)
  {
    Vectors scaled(residual);
    for (std::size_t v = 0; v < scaled.size(); ++v)
    {
      scaled[v] /= diagonal[v];
    }
    const double now = dot(residual, scaled);
    first = step == 0 ? now : first;
    if (!(now > kSolverTolerance * kSolverTolerance * first))
    {
      break;
    }
    for (std::size_t v = 0; v < scaled.size() && step > 0; ++v)
    {
      scaled[v] += now / last * search[v];
    }
    search = std::move(scaled);
    last = now;
    const Vectors product = apply(search);
    const double length = now / dot(search, product);
    for (std::size_t v = 0; v < x.size(); ++v)
    {
      x[v] += length * search[v];
      residual[v] -= length * product[v];
    }
  }
  return x;
}

class Fit
{
public:
  Fit(const std::vector<TangentPlane>& planes, const std::vector<int>& representatives,
    const BallComplex& complex, std::vector<Ball>& balls)
    : complex_(complex)
    , balls_(balls)
    , quadrics_(balls.size())
  {
    const std::size_t enough = std::max(kMinPoints, kPointsPerBall * complex.vertices().size());
    const int stride = static_cast<int>((planes.size() + enough - 1) / enough);
    for (const TangentPlane& plane : planes)
    {
      const int owner = representatives[plane.vertex];
      if (!complex.isVertex(owner))
      {
        continue; // left out
      }
      quadrics_[owner].addPlane(plane.point, plane.normal, plane.weight * kOwn);
      if (plane.vertex % stride == 0)
      {
        planes_.push_back(plane);
        planes_.back().weight *= stride;
        owners_.push_back(owner);
        weight_ += planes_.back().weight;
      }
    }
  }

  void run(const std::function<void(double)>& report)
  {
    double error = this->measure(balls_);
    for (int step = 0; step < kSteps && error > kExact * kExact * weight_; ++step)
    {
      report(1.0 * step / kSteps);
      const std::vector<Ball> before = balls_;
      this->move(this->solve());
      const double next = this->measure(balls_);
      if (!(next < error))
      {
        balls_ = before;
        return;
      }
      if (next > (1.0 - kGain) * error)
      {
        return;
      }
      error = next;
    }
  }

private:
  /// Finds the nearest place of the model for every point.
  /// @return the sum of squares.
  double measure(const std::vector<Ball>& balls)
  {
    nearest_.resize(planes_.size());
    const ModelDistance model(complex_, balls);
    tbb::parallel_for(std::size_t{ 0 }, planes_.size(),
      [&](std::size_t i)
      {
        nearest_[i] = model.nearest(planes_[i].point, owners_[i]);
        owners_[i] = nearest_[i].mainVertex();
      });
    double sum = 0.0;
    for (std::size_t i = 0; i < planes_.size(); ++i)
    {
      sum += planes_[i].weight * nearest_[i].distance * nearest_[i].distance;
    }
    for (const int v : complex_.vertices())
    {
      sum += quadrics_[v](toVector(balls[v]));
    }
    return sum;
  }

  /// Derivatives of a distance by the balls: minus the share of each corner times (direction, 1).
  template <typename Visit>
  void forEachCorner(std::size_t i, const Visit& visit) const
  {
    const NearestCell& nearest = nearest_[i];
    for (int k = 0; k < 3; ++k)
    {
      if (nearest.shares[k] > 0.0)
      {
        visit(nearest.corners[k], nearest.shares[k]);
      }
    }
  }

  /// Multiplies a vector by the matrix of the normal equations.
  Vectors apply(const Vectors& x) const
  {
    Vectors result(x.size(), glm::dvec4(0.0));
    for (std::size_t i = 0; i < planes_.size(); ++i)
    {
      const glm::dvec4 direction(nearest_[i].direction, 1.0);
      double change = 0.0;
      this->forEachCorner(i,
        [&](int v, double share) { change += share * glm::dot(direction, x[v]); });
      change *= planes_[i].weight;
      this->forEachCorner(i, [&](int v, double share) { result[v] += share * change * direction; });
    }
    for (std::size_t v = 0; v < x.size(); ++v)
    {
      result[v] += damping_[v] * x[v] + quadrics_[v].times(x[v]);
    }
    return result;
  }

  /// Returns the step: the solution of the damped normal equations.
  Vectors solve()
  {
    Vectors right(balls_.size(), glm::dvec4(0.0));
    Vectors diagonal(balls_.size(), glm::dvec4(0.0));
    damping_.assign(balls_.size(), 0.0);
    for (std::size_t i = 0; i < planes_.size(); ++i)
    {
      const glm::dvec4 direction(nearest_[i].direction, 1.0);
      const double weight = planes_[i].weight;
      this->forEachCorner(i,
        [&](int v, double share)
        {
          right[v] += weight * share * nearest_[i].distance * direction;
          diagonal[v] += weight * share * share * direction * direction;
          damping_[v] += kDamping * weight * share * share;
        });
    }
    for (std::size_t v = 0; v < balls_.size(); ++v)
    {
      damping_[v] = std::max(damping_[v], kMinDamping);
      diagonal[v] += damping_[v] + quadrics_[v].diagonal();
      right[v] += quadrics_[v].linear() - quadrics_[v].times(toVector(balls_[v]));
    }
    return solveConjugate([this](const Vectors& x) { return this->apply(x); }, diagonal,
      std::move(right));
  }

  /// Moves one ball after the other, as far as triangles allow.
  void move(const Vectors& step)
  {
    for (const int v : complex_.vertices())
    {
      Ball moved = toBall(toVector(balls_[v]) + step[v]);
      moved.radius = std::max(moved.radius, 0.0);
      const auto& triangles = complex_.trianglesOf(v);
      const bool allowed = std::all_of(triangles.begin(), triangles.end(),
        [&](int t)
        {
          TrianglePoints before{};
          TrianglePoints after{};
          for (int k = 0; k < 3; ++k)
          {
            const int corner = complex_.triangle(t)[k];
            before[k] = balls_[corner].centre;
            after[k] = corner == v ? moved.centre : before[k];
          }
          return keepsShape(before, after);
        });
      if (allowed)
      {
        balls_[v] = moved;
      }
    }
  }

  std::vector<TangentPlane> planes_;
  const BallComplex& complex_;
  std::vector<Ball>& balls_;
  std::vector<int> owners_; ///< a ball next to each point
  std::vector<NearestCell> nearest_;
  std::vector<BallQuadric> quadrics_; ///< of the balls by themselves
  double weight_ = 0.0;
  std::vector<double> damping_;
};

} // namespace

void fitBalls(const std::vector<TangentPlane>& planes, const std::vector<int>& representatives,
  const BallComplex& complex, std::vector<Ball>& balls, const std::function<void(double)>& step)
{
  Fit(planes, representatives, complex, balls).run(step);
}

} // namespace medial
